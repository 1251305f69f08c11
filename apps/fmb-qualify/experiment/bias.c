/* bias.c: fmb-qualify bias: is the clock fair? The same rules take part twice, and are timed
 * against each other like two ways of an experiment, again and again on other systems. The interval
 * of the ratio must contain 1 about as often as its confidence level says. */
#include <argp.h>
#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "common/value.h"
#include "fmb-qualify/experiment/experiment.h"
#include "fmb-qualify/watch.h"
#include "study/clock/ratio.h"

typedef struct trials {
    int repetitions, passes;
    bool quiet;
} trials;

/* The times of both, on all systems that both decided [s]. */
typedef struct times {
    double *first, *second;
    size_t size;
} times;

enum { SEEDS = 3 }; /* of a block, as in the benchmark */

/* [give, qualify_experiment_clear] The smallest systems of all families, others each time. Other
 * rules take part, so that not always the same way runs before one of the two. */
static int make_plan(const trials *t, int repetition, qualify_experiment *e)
{
    int seed = SEEDS * repetition;
    json_t *plan = json_pack("{s:[ssss], s:[i], s:[iii], s:i, s:{s:i, s:i}}", "rules", "none", "lp",
                             "none", "default", "sizes", 1, "seeds", seed + 1, seed + 2, seed + 3,
                             "passes", t->passes, "limits", "rows", 1000, "seconds", 10);
    return qualify_experiment_take(app_need(plan), "bias", e);
}

static void put_block(const study_grid *g, times *all)
{
    for (size_t i = 0; i < g->sample[0].size; i++) {
        const study_run *a = study_grid_at(g, 0, i, 0), *b = study_grid_at(g, 0, i, 2);
        if (a->solved != STUDY_DECIDED || b->solved != STUDY_DECIDED)
            continue;
        all->first[all->size] = a->seconds;
        all->second[all->size++] = b->seconds;
    }
}

static int take_times(const qualify_experiment *e, size_t done, size_t of, times *all)
{
    int code = APP_YES;
    for (size_t b = 0; code == APP_YES && b < e->blocks; b++) {
        study_grid g = {0};
        if (!qualify_watch_step(NULL, done * e->blocks + b, of * e->blocks))
            return APP_UNDECIDED;
        code = qualify_block_run(e, b, &g);
        if (code == APP_YES)
            put_block(&g, all);
        study_grid_clear(&g);
    }
    return code;
}

static bool holds_one(study_ratio r)
{
    return r.low <= 1 && 1 <= r.high;
}

static int repeat(const trials *t, int repetition, int hits[2])
{
    qualify_experiment e;
    int code = make_plan(t, repetition, &e);
    size_t most = code == APP_YES ? e.blocks * e.seeds : 0;
    times all = {.first = app_need(malloc(2 * (most + 1) * sizeof(double)))};
    all.second = all.first + most;
    if (code == APP_YES)
        code = take_times(&e, (size_t)repetition, (size_t)t->repetitions, &all);
    if (code == APP_YES) {
        study_ratio sums = study_ratio_of_sums(all.first, all.second, all.size);
        study_ratio median = study_median_of_ratios(all.first, all.second, all.size);
        printf("%d,%zu,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", repetition + 1, all.size, sums.ratio,
               sums.low, sums.high, median.ratio, median.low, median.high);
        hits[0] += holds_one(sums);
        hits[1] += holds_one(median);
    }
    free(all.first);
    qualify_experiment_clear(&e);
    return code;
}

static int repeat_all(const trials *t)
{
    int hits[2] = {0, 0}, code = APP_YES;
    puts("repetition,systems,total,total_low,total_high,median,median_low,median_high");
    qualify_watch_begin(t->quiet);
    qualify_watch_name("bias");
    for (int r = 0; code == APP_YES && r < t->repetitions; r++)
        code = repeat(t, r, hits);
    qualify_watch_end();
    if (code == APP_YES)
        fprintf(stderr,
                "1 lies in %d of %d intervals of the ratio of totals, in %d of %d of the median "
                "ratio\n",
                hits[0], t->repetitions, hits[1], t->repetitions);
    return code;
}

/* ---- the command line ------------------------------------------------------------------------ */

enum { KEY_REPETITIONS = 0x100, KEY_PASSES };

static const struct argp_option options[] = {
    {"repetitions", KEY_REPETITIONS, "N", 0, "How often, on other systems each time [40]", 1},
    {"passes", KEY_PASSES, "N", 0, "Passes that count [3]", 1},
    {"quiet", 'q', NULL, 0, "No progress bar", 2},
    {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    trials *t = state->input;
    switch (key) {
    case KEY_REPETITIONS:
        t->repetitions = (int)app_value_whole("--repetitions", arg, 1, 100000, state);
        return 0;
    case KEY_PASSES:
        t->passes = (int)app_value_whole("--passes", arg, 1, 9, state);
        return 0;
    case 'q':
        t->quiet = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] =
    "Is the clock fair? The rules `none` are timed against `none`, as two ways of an experiment "
    "are, on the smallest systems of all families of the benchmark, others in each repetition. "
    "Each is a line of CSV: the ratio of the totals and the median ratio, with intervals of 95 %, "
    "which should contain 1 in 95 % of cases."
    "\v"
    "docs/laboratory.md shows what was found.\n";

int qualify_bias(int argc, char **argv)
{
    const struct argp whole_line = {options, parse, NULL, doc, NULL, NULL, NULL};
    trials t = {.repetitions = 40, .passes = 3};
    argp_parse(&whole_line, argc, argv, 0, NULL, &t);
    return repeat_all(&t);
}
