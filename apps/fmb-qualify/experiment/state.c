/* state.c: see state.h. The lines of a block are consecutive. */
#include "fmb-qualify/experiment/state.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"

/* The block of a line of this experiment, from 0; -1 for any other line. */
static long block_of(const qualify_experiment *e, const char *line)
{
    size_t n = strlen(e->name);
    if (strncmp(line, e->name, n) != 0 || line[n] != ',')
        return -1;
    long block = strtol(line + n + 1, NULL, 10);
    return block >= 1 && (size_t)block <= e->blocks ? block - 1 : -1;
}

static int read_lines(const qualify_experiment *e, const char *path, FILE *f, bool *done, long *end)
{
    char *line = NULL;
    size_t room = 0, lines = 0;
    ssize_t n;
    long last = -1;
    int code = APP_YES;
    while (code == APP_YES && (n = getline(&line, &room, f)) > 0 && line[n - 1] == '\n') {
        if (*end == 0 && strcmp(line, qualify_experiment_header) == 0) {
            *end = n;
            continue;
        }
        long block = *end > 0 ? block_of(e, line) : -1;
        lines = block == last ? lines + 1 : 1;
        last = block;
        if (block < 0)
            code = app_error(APP_BAD_INPUT, "%s: not an output of this plan", path);
        else if (lines == qualify_block_size(e, (size_t)block) * e->ways) {
            done[block] = true;
            *end = ftell(f);
        }
    }
    free(line);
    return code;
}

int qualify_state_read(const qualify_experiment *e, const char *path, bool *done, long *end)
{
    FILE *f = fopen(path, "rb");
    *end = 0;
    if (!f)
        return errno == ENOENT ? APP_YES
                               : app_error(APP_CANNOT_OPEN, "%s: %s", path, strerror(errno));
    int code = read_lines(e, path, f, done, end);
    fclose(f);
    return code;
}
