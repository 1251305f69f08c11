/* main.c: how long each way of a projection takes on problems of all families, with what the
 * problems are like: a JSON object a line, which fit.py reads. See ../../README.md.
 *
 * An arm is a method, or the portfolio with some of its ways switched off. All arms of a problem
 * run one after another in this process, on its own processor time; one that takes longer than the
 * limit is null.
 */
#define _DEFAULT_SOURCE /* setitimer */
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>

#include <fmb/fmb.h>

#include "base/clock.h"
#include "base/ways.h"
#include "simulate.h"
#include "solve/portfolio/features.h"
#include "study/program/program.h"
#include "study/program/projection.h"

static const char USAGE[] = "usage: bench-selection [--seed N] [--each N] [--seconds S]\n"
                            "Problems of all families of projections, N seeds of each.\n";

#define BIT(way) ((uint32_t)1 << FMB_WAY_##way)

static const struct {
    const char *name;
    fmb_method method;
    uint32_t off;
} ARM[] = {
    {"rules", FMB_METHOD_AUTO, 0},
    {"fm", FMB_METHOD_FM, 0},
    {"dd", FMB_METHOD_DD, 0},
    {"hull", FMB_METHOD_HULL, 0},
    {"no-bounded", FMB_METHOD_AUTO, BIT(BOUNDED_GROWTH)},
    {"no-pruned", FMB_METHOD_AUTO, BIT(PRUNED)},
    {"no-rays", FMB_METHOD_AUTO, BIT(FIRST_RAYS) | BIT(SECOND_RAYS) | BIT(HIGHER_GROWTH)},
};

enum { ARMS = sizeof ARM / sizeof *ARM };

/* Of the largest part that was heard of. */
typedef struct heard {
    bool any;
    fmb_features features;
    simulated_rows simulated;
} heard;

static void fail(const char *what)
{
    fprintf(stderr, "bench-selection: %s\n", what);
    exit(71);
}

static void hear_part(void *self, const fmb_features *f, const fmb_reduced_part *reduced)
{
    heard *h = self;
    if (!reduced->rest || (h->any && h->features.entries >= f->entries))
        return;
    h->any = true;
    h->features = *f;
    if (!simulate_elimination(reduced, &h->simulated))
        fail("no memory");
}

/* Limits of time are on a clock that others slow down, so processor time ends a query here. */
static fmb_solver *asked;

static void end_query(int signal)
{
    (void)signal;
    fmb_solver_cancel(asked);
}

static void end_query_after(double seconds)
{
    struct timeval after = {(time_t)seconds, (suseconds_t)((seconds - floor(seconds)) * 1e6)};
    setitimer(ITIMER_PROF, &(struct itimerval){.it_value = after}, NULL);
}

/* [s] of one query; below 0 if it did not end. */
static double time_once(fmb_solver *v, const fmb_system *s, const int *keep, int kept,
                        double seconds)
{
    fmb_result r = {.size = sizeof r};
    fmb_system *out = NULL;
    asked = v;
    end_query_after(seconds);
    double begin = fmb_clock_seconds(CLOCK_THREAD_CPUTIME_ID);
    if (fmb_project(v, s, keep, kept, &out, &r) != FMB_OK)
        fail("a projection failed");
    double end = fmb_clock_seconds(CLOCK_THREAD_CPUTIME_ID);
    end_query_after(0);
    fmb_system_free(out);
    return r.stop == FMB_STOP_DONE ? end - begin : -1;
}

/* Short queries are asked again: the least of up to five. */
#define LONG_ENOUGH 0.02 /* [s] */
#define MOST_RUNS   5

static double time_arm(int arm, const fmb_system *s, const int *keep, int kept, double seconds)
{
    fmb_options o = {.size = sizeof o, .method = ARM[arm].method};
    fmb_solver *v;
    o.evidence = FMB_EVIDENCE_NONE;
    memset(fmb_ways_at_hand, 0, sizeof *fmb_ways_at_hand);
    for (int way = 0; way < FMB_WAY_COUNT; way++)
        fmb_ways_at_hand->off[way] = ARM[arm].off >> way & 1;
    if (fmb_solver_new(&o, NULL, &v) != FMB_OK)
        fail("no memory");
    double least = time_once(v, s, keep, kept, seconds), total = least;
    for (int i = 1; least >= 0 && i < MOST_RUNS && total < LONG_ENOUGH; i++) {
        double next = time_once(v, s, keep, kept, seconds);
        total += next;
        least = next >= 0 && next < least ? next : least;
    }
    fmb_solver_free(v);
    return least;
}

static void print_features(const heard *h)
{
    const fmb_features *f = &h->features;
    printf("\"kept\": %d, \"variables\": %d, \"given\": %zu, \"strict\": %d, \"wide\": %d, "
           "\"columns\": %zu, \"rows\": %zu, \"entries\": %zu, \"bounds\": %zu, \"freedom\": %zu, "
           "\"minor_bits\": %zu, \"long\": %d, \"origin\": %d, \"simulated_most\": %zu, "
           "\"simulated_last\": %zu, \"simulated_left\": %d",
           f->kept, f->variables, f->given, f->is_strict, f->is_wide, f->columns, f->rows,
           f->entries, f->bounds, f->freedom, f->minor_bits, f->is_long, f->has_origin,
           h->simulated.most, h->simulated.last, h->simulated.left);
}

/* What no way is chosen for is left out. */
static void study_problem(const char *family, int digits, uint64_t seed, const fmb_system *s,
                          int kept, double seconds)
{
    int *keep = malloc((size_t)kept * sizeof *keep);
    heard h = {.any = false};
    double took[ARMS];
    if (!keep)
        fail("no memory");
    for (int k = 0; k < kept; k++)
        keep[k] = k;
    for (int arm = 0; arm < ARMS && (arm == 0 || h.any); arm++) {
        fmb_features_watch = (fmb_features_watcher){NULL, NULL};
        took[arm] = time_arm(arm, s, keep, kept, seconds);
        fmb_features_watch = (fmb_features_watcher){hear_part, &h};
        if (arm == 0)
            (void)time_arm(arm, s, keep, kept, seconds);
    }
    if (h.any) {
        printf("{\"family\": \"%s\", \"digits\": %d, \"seed\": %" PRIu64 ", \"limit\": %g, ",
               family, digits, seed, seconds);
        print_features(&h);
        for (int arm = 0; arm < ARMS; arm++)
            if (took[arm] >= 0)
                printf(", \"%s\": %.7f", ARM[arm].name, took[arm]);
            else
                printf(", \"%s\": null", ARM[arm].name);
        puts("}");
        fflush(stdout);
    }
    free(keep);
}

static const int DIGITS[] = {0, 9};

static void study_family(int family, uint64_t seed, int digits, double seconds)
{
    study_projection drawn;
    fmb_system *dressed = NULL;
    if (study_projection_draw(family, seed, &drawn) != FMB_OK ||
        (digits > 0 && study_system_fractions(drawn.s, digits, seed, &dressed) != FMB_OK))
        fail("no memory");
    study_problem(study_projection_name(family), digits, seed, dressed ? dressed : drawn.s,
                  drawn.keep, seconds);
    fmb_system_free(dressed);
    fmb_system_free(drawn.s);
}

int main(int argc, char **argv)
{
    uint64_t first = 1, each = 4;
    double seconds = 1;
    signal(SIGPROF, end_query);
    for (int i = 1; i < argc; i += 2) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--seed") == 0 && *value)
            first = strtoull(value, NULL, 10);
        else if (strcmp(argv[i], "--each") == 0 && *value)
            each = strtoull(value, NULL, 10);
        else if (strcmp(argv[i], "--seconds") == 0 && *value)
            seconds = atof(value);
        else
            return fputs(USAGE, stderr), 64;
    }
    for (uint64_t seed = first; seed < first + each; seed++)
        for (int f = 0; f < study_projections(); f++)
            for (size_t k = 0; k < sizeof DIGITS / sizeof *DIGITS; k++)
                study_family(f, seed, DIGITS[k], seconds);
    return 0;
}
