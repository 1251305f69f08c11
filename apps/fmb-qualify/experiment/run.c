/* run.c: fmb-qualify run: runs an experiment, from the end of its CSV file on. */
#include <argp.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/message.h"
#include "common/parts.h"
#include "common/ranks.h"
#include "fmb-qualify/experiment/state.h"
#include "fmb-qualify/share.h"
#include "fmb-qualify/watch.h"
#include "study/clock/clock.h"

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

static int run_block(const qualify_experiment *e, size_t block, FILE *f, uint64_t *wrong)
{
    study_grid g = {0};
    int code = qualify_block_run(e, block, &g);
    if (code == APP_YES) {
        qualify_block_write(e, block, &g, f);
        *wrong += count_wrong(&g, e->ways);
    }
    study_grid_clear(&g);
    return code;
}

/* With several ranks, the time between collections of lines [s]: a kill loses at most that. A
 * single rank writes after each block. */
static const double SLICE_SECONDS = 5;

/* Runs some of the remaining blocks on this rank: at least one, if any. */
static int run_slice(const order_to_run *o, const qualify_experiment *e, const bool *done, FILE *f,
                     uint64_t *wrong)
{
    double end = study_thread_seconds() + (app_ranks() > 1 ? SLICE_SECONDS : 0);
    int code = APP_YES;
    for (bool ran = false; code == APP_YES && (!ran || study_thread_seconds() < end);) {
        size_t b = (size_t)app_ranks_take(0, 1);
        if (b >= e->blocks)
            break;
        if (!qualify_watch_step(NULL, b, e->blocks))
            return APP_UNDECIDED;
        if (is_mine(o, b) && !done[b]) {
            code = run_block(e, b, f, wrong);
            ran = true;
        }
    }
    return code;
}

/* Flushed at once: after a kill at most one block is incomplete. */
static int write_lines(const char *text, size_t n, FILE *f)
{
    return fwrite(text, 1, n, f) == n && fflush(f) == 0 && fsync(fileno(f)) == 0
               ? APP_YES
               : app_error(APP_CANNOT_WRITE, "%s", strerror(errno));
}

/* The first rank collects and writes the lines of all ranks; no lines: all is done. */
static int collect_lines(const char *text, size_t n, FILE *f, bool *goes_on)
{
    size_t all = 0;
    char *lines = app_ranks_gather(text, n, &all);
    int code = f && all > 0 ? write_lines(lines, all, f) : APP_YES;
    free(lines);
    *goes_on = all > 0;
    app_ranks_share(goes_on, sizeof *goes_on);
    return code;
}

/* f is NULL except on the first rank. */
static int run_blocks(const order_to_run *o, const qualify_experiment *e, const bool *done, FILE *f)
{
    uint64_t wrong = 0;
    int code = APP_YES;
    for (bool goes_on = true; code == APP_YES && goes_on;) {
        char *text = NULL;
        size_t n = 0;
        FILE *lines = app_need(open_memstream(&text, &n));
        code = run_slice(o, e, done, lines, &wrong);
        if (fclose(lines) != 0)
            app_need(NULL);
        if (code == APP_YES)
            code = collect_lines(text, n, f, &goes_on);
        free(text);
    }
    if (code != APP_YES)
        return app_ranks_fail(code);
    app_ranks_sum(&wrong, 1);
    return wrong > 0 && f ? app_error(APP_NO, "%llu wrong answers", (unsigned long long)wrong)
                          : APP_YES;
}

/* [give] The file, truncated to its last complete block. */
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

/* The first rank reads the state of an earlier run and opens the file; all get the state. */
static int begin(const order_to_run *o, const qualify_experiment *e, bool *done, FILE **f)
{
    long end;
    int code = APP_YES;
    if (app_rank() == 0)
        code = qualify_state_read(e, o->out, done, &end);
    if (code == APP_YES && app_rank() == 0)
        code = open_results(o->out, end, f);
    code = app_ranks_agree(code);
    if (code == APP_YES)
        app_ranks_share(done, e->blocks * sizeof *done);
    return code;
}

static int run(const order_to_run *o, const qualify_experiment *e)
{
    bool *done = app_need(calloc(e->blocks, sizeof *done));
    FILE *f = NULL;
    int code = begin(o, e, done, &f);
    if (code == APP_YES) {
        qualify_watch_begin(o->quiet);
        qualify_watch_name("run");
        code = run_blocks(o, e, done, f);
        qualify_watch_end();
    }
    if (f && fclose(f) != 0 && code == APP_YES)
        code = app_ranks_fail(app_error(APP_CANNOT_WRITE, "%s: %s", o->out, strerror(errno)));
    free(done);
    return code;
}

/* All ranks read the plan: the first one before the others, that its errors are reported once. */
static int read_plan(const order_to_run *o, qualify_experiment *e)
{
    int code = app_rank() == 0 ? qualify_experiment_read(o->plan, e) : APP_YES;
    code = app_ranks_agree(code);
    if (code != APP_YES || app_rank() == 0)
        return code;
    code = qualify_experiment_read(o->plan, e);
    return code == APP_YES ? code : app_ranks_fail(code);
}

static int read_and_run(const order_to_run *o)
{
    qualify_experiment e = {0};
    int code = read_plan(o, &e);
    if (code == APP_YES)
        code = run(o, &e);
    qualify_experiment_clear(&e);
    return code;
}

/* ---- the command line ------------------------------------------------------------------------ */

enum { KEY_SHARD = 0x100 };

static const struct argp_option options[] = {
    {"out", 'o', "FILE", 0, "The CSV file; an existing one is continued [PLAN.csv]", 1},
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
                          "An interrupted run continues where its file ends. "
                          "docs/laboratory.md describes plans "
                          "and columns.\n"
                          "\n"
                          "Examples:\n"
                          "  fmb-qualify run plan.json --out runs.csv\n"
                          "  fmb-qualify run plan.json --shard 1/2 --out a.csv\n"
                          "  fmb-qualify merge a.csv b.csv >runs.csv\n"
                          "  mpirun -n 8 fmb-qualify run plan.json\n";

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
    argp_parse(&whole_line, argc, argv, 0, NULL, &o);
    char *usual = usual_results(o.plan);
    o.out = o.out ? o.out : usual;
    int code = qualify_join_ranks();
    if (code == APP_YES)
        code = qualify_leave_ranks(read_and_run(&o));
    free(usual);
    return code;
}
