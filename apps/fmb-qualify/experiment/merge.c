/* merge.c: fmb-qualify merge: merges the shards of an experiment into one file, blocks in order. */
#include <argp.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "fmb-qualify/experiment/experiment.h"

typedef struct line {
    char *text;
    long block;
    size_t place; /* in the order of reading */
} line;

typedef struct pile {
    line *line;
    size_t size, capacity;
    char **file; /* borrowed */
    size_t files;
} pile;

static void put_line(pile *p, char *text, long block)
{
    if (p->size == p->capacity) {
        p->capacity = p->capacity ? 2 * p->capacity : 1024;
        p->line = app_need(realloc(p->line, p->capacity * sizeof *p->line));
    }
    p->line[p->size] = (line){text, block, p->size};
    p->size++;
}

/* The number after the first comma; 0 if there is none. */
static long block_of(const char *text)
{
    const char *comma = strchr(text, ',');
    return comma ? strtol(comma + 1, NULL, 10) : 0;
}

/* Are all lines whole, and of one plan? */
static bool fits(const pile *p, const char *text, size_t n)
{
    size_t name = strcspn(text, ",");
    return text[n - 1] == '\n' && block_of(text) > 0 &&
           (p->size == 0 || strncmp(text, p->line[0].text, name + 1) == 0);
}

static int read_file(const char *path, pile *p)
{
    FILE *f = NULL;
    char *text = NULL;
    size_t room = 0;
    ssize_t n;
    int code = app_file_open(path, &f);
    if (code != APP_YES)
        return code;
    if (getline(&text, &room, f) <= 0 || strcmp(text, qualify_experiment_header) != 0)
        code = app_error(APP_BAD_INPUT, "%s: not an output of `fmb-qualify run`", path);
    while (code == APP_YES && (n = getline(&text, &room, f)) > 0)
        if (fits(p, text, (size_t)n))
            put_line(p, app_need(strdup(text)), block_of(text));
        else
            code = app_error(APP_BAD_INPUT, "%s: a line that was torn, or of another plan", path);
    free(text);
    app_file_close_input(f);
    return code;
}

static int by_block(const void *a, const void *b)
{
    const line *x = a, *y = b;
    int order = (x->block > y->block) - (x->block < y->block);
    return order ? order : (x->place > y->place) - (x->place < y->place);
}

/* Prints the blocks; all lines of a block must be from one file. */
static int print(pile *p)
{
    qsort(p->line, p->size, sizeof *p->line, by_block);
    for (size_t i = 1; i < p->size; i++)
        if (p->line[i].block == p->line[i - 1].block &&
            p->line[i].place != p->line[i - 1].place + 1)
            return app_error(APP_BAD_INPUT, "block %ld is there twice", p->line[i].block);
    fputs(qualify_experiment_header, stdout);
    for (size_t i = 0; i < p->size; i++)
        fputs(p->line[i].text, stdout);
    return APP_YES;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    pile *p = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        p->file = app_need(realloc(p->file, (p->files + 1) * sizeof *p->file));
        p->file[p->files++] = arg;
        return 0;
    case ARGP_KEY_END:
        if (p->files == 0)
            argp_error(state, "expected files of CSV");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] = "Join the outputs of the shards of `fmb-qualify run` to one CSV file.";

int qualify_merge(int argc, char **argv)
{
    const struct argp whole_line = {NULL, parse, "FILE...", doc, NULL, NULL, NULL};
    pile p = {0};
    argp_parse(&whole_line, argc, argv, 0, NULL, &p);
    int code = APP_YES;
    for (size_t i = 0; code == APP_YES && i < p.files; i++)
        code = read_file(p.file[i], &p);
    if (code == APP_YES)
        code = print(&p);
    for (size_t i = 0; i < p.size; i++)
        free(p.line[i].text);
    free(p.line);
    free(p.file);
    return code;
}
