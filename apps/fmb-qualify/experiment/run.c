/* run.c: fmb-qualify run: an experiment, from where its file of CSV ends. */
#include <argp.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/message.h"
#include "common/parts.h"
#include "fmb-qualify/experiment/state.h"
#include "fmb-qualify/watch.h"

typedef struct order_to_run {
    const char *plan, *out;
    uint64_t shard, shards;
    bool quiet;
} order_to_run;

static bool is_mine(const order_to_run *o, size_t block)
{
    return o->shards == 0 || block % o->shards == o->shard - 1;
}

static size_t count_wrong(const study_grid *g, size_t ways)
{
    size_t wrong = 0;
    for (size_t i = 0; i < g->sample[0].size * ways; i++)
        wrong += g->run[i].outcome == STUDY_WRONG || g->run[i].solved == STUDY_WRONG;
    return wrong;
}

/* Written at once: what a kill leaves behind is one block at most that is not whole. */
static int write_block(const qualify_experiment *e, size_t block, const study_grid *g, FILE *f)
{
    qualify_block_write(e, block, g, f);
    return fflush(f) == 0 && fsync(fileno(f)) == 0
               ? APP_YES
               : app_error(APP_CANNOT_WRITE, "%s", strerror(errno));
}

static int run_block(const qualify_experiment *e, size_t block, FILE *f, size_t *wrong)
{
    study_grid g = {0};
    int code = qualify_block_run(e, block, &g);
    if (code == APP_YES)
        code = write_block(e, block, &g, f);
    if (code == APP_YES)
        *wrong += count_wrong(&g, e->ways);
    study_grid_clear(&g);
    return code;
}

static int run_blocks(const order_to_run *o, const qualify_experiment *e, const bool *done, FILE *f)
{
    size_t wrong = 0;
    int code = APP_YES;
    for (size_t b = 0; code == APP_YES && b < e->blocks; b++) {
        if (!qualify_watch_step(NULL, b, e->blocks))
            return APP_UNDECIDED;
        if (is_mine(o, b) && !done[b])
            code = run_block(e, b, f, &wrong);
    }
    if (code == APP_YES && wrong > 0)
        code = app_error(APP_NO, "%zu wrong answers", wrong);
    return code;
}

/* [give] The file, cut where its last whole block ends. */
static int open_results(const char *path, long end, FILE **out)
{
    FILE *f = fopen(path, end > 0 ? "r+b" : "wb");
    if (!f || (end > 0 && (ftruncate(fileno(f), end) != 0 || fseek(f, 0, SEEK_END) != 0)))
        return app_error(APP_CANNOT_WRITE, "%s: %s", path, strerror(errno));
    if (end == 0)
        fputs(qualify_experiment_header, f);
    *out = f;
    return APP_YES;
}

static int run(const order_to_run *o, const qualify_experiment *e)
{
    bool *done = app_need(calloc(e->blocks, sizeof *done));
    FILE *f = NULL;
    long end;
    int code = qualify_state_read(e, o->out, done, &end);
    if (code == APP_YES)
        code = open_results(o->out, end, &f);
    if (code == APP_YES) {
        qualify_watch_begin(o->quiet);
        qualify_watch_name("run");
        code = run_blocks(o, e, done, f);
        qualify_watch_end();
    }
    if (f && fclose(f) != 0 && code == APP_YES)
        code = app_error(APP_CANNOT_WRITE, "%s: %s", o->out, strerror(errno));
    free(done);
    return code;
}

/* ---- the command line ------------------------------------------------------------------------ */

enum { KEY_SHARD = 0x100 };

static const struct argp_option options[] = {
    {"out", 'o', "FILE", 0,
     "Where the lines of CSV go; one that is there is gone on with [PLAN.csv]", 1},
    {"shard", KEY_SHARD, "I/N", 0, "Only every N-th block, from the I-th on", 1},
    {"quiet", 'q', NULL, 0, "No progress bar", 2},
    {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    order_to_run *o = state->input;
    switch (key) {
    case 'o':
        o->out = arg;
        return 0;
    case KEY_SHARD:
        app_shard_parse(arg, &o->shard, &o->shards, state);
        return 0;
    case 'q':
        o->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (o->plan)
            argp_error(state, "expected one plan, found '%s'", arg);
        o->plan = arg;
        return 0;
    case ARGP_KEY_END:
        if (!o->plan)
            argp_error(state, "expected a plan");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] = "Run an experiment: rules x orders x methods x families x sizes x digits "
                          "x density x seeds, each run a line "
                          "of CSV. Every answer is compared with the exact one."
                          "\v"
                          "What was stopped goes on where its file ends, also after a kill. "
                          "docs/laboratory.md tells of plans "
                          "and columns.\n"
                          "\n"
                          "Examples:\n"
                          "  fmb-qualify run plan.json --out runs.csv\n"
                          "  fmb-qualify run plan.json --shard 1/2 --out a.csv\n"
                          "  fmb-qualify merge a.csv b.csv >runs.csv\n";

/* "a/plan.json" without its ending and with .csv. */
static char *usual_results(const char *plan)
{
    char *path;
    size_t n = strlen(plan);
    n -= n > 5 && strcmp(plan + n - 5, ".json") == 0 ? 5 : 0;
    if (asprintf(&path, "%.*s.csv", (int)n, plan) < 0)
        app_need(NULL);
    return path;
}

int qualify_run(int argc, char **argv)
{
    const struct argp whole_line = {options, parse, "PLAN", doc, NULL, NULL, NULL};
    order_to_run o = {0};
    qualify_experiment e;
    argp_parse(&whole_line, argc, argv, 0, NULL, &o);
    char *usual = usual_results(o.plan);
    o.out = o.out ? o.out : usual;
    int code = qualify_experiment_read(o.plan, &e);
    if (code == APP_YES)
        code = run(&o, &e);
    qualify_experiment_clear(&e);
    free(usual);
    return code;
}
