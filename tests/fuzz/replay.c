/* replay.c: a fuzz target without a fuzzer: runs it on every file of the folders named as
 * arguments, whole and cut short at every length.
 */
#include <dirent.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "round.h"

/* Runs on a copy of the exact size, so that a sanitizer sees a byte read too far. */
static int run(const uint8_t *data, size_t size)
{
    uint8_t *copy = malloc(size ? size : 1);
    if (!copy)
        return 1;
    memcpy(copy, data, size);
    int bad = LLVMFuzzerTestOneInput(copy, size);
    free(copy);
    return bad;
}

static int run_file(const char *path)
{
    static uint8_t data[1 << 16];
    FILE *in = fopen(path, "rb");
    if (!in)
        return 1;
    size_t size = fread(data, 1, sizeof data, in);
    fclose(in);
    int bad = 0;
    for (size_t n = size < 2048 ? 0 : size; n <= size; n++)
        bad |= run(data, n);
    return bad;
}

/* Number of files run, or -1. */
static int run_folder(const char *folder)
{
    char path[PATH_MAX];
    int n = 0;
    DIR *d = opendir(folder);
    if (!d)
        return -1;
    for (struct dirent *e; n >= 0 && (e = readdir(d)) != NULL;) {
        if (e->d_name[0] == '.')
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        n = run_file(path) ? -1 : n + 1;
    }
    closedir(d);
    return n;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        int n = run_folder(argv[i]);
        if (n <= 0) {
            fprintf(stderr, "%s: no files, or one failed\n", argv[i]);
            return 1;
        }
        printf("%s: %d files\n", argv[i], n);
    }
    return argc > 1 ? 0 : 1;
}
