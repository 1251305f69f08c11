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
#include "simulate.h"
#include "solve/portfolio/features.h"
#include "solve/portfolio/selection.h"
#include "study/program/program.h"
#include "study/program/projection.h"

static const char USAGE[] =
    "usage: bench-selection [--seed N] [--each N] [--seconds S]\n"
    "Problems of all families of projections, N seeds of each; 0 seconds: features alone.\n";

/* What the library chooses, and then its pipelines. */
static int count_arms(void)
{
    int n = 0;
    while (fmb_selection_name(n))
        n++;
    return n + 1;
}

static const char *name_of_arm(int arm)
{
    return arm == 0 ? "auto" : fmb_selection_name(arm - 1);
}

enum { MOST_ARMS = 64 };

/* Of the largest part that was heard of. */
typedef struct heard {
    bool any;
    size_t entries;
    double value[FMB_FEATURE_COUNT];
    simulated_elimination simulated;
} heard;

static void fail(const char *what)
{
    fprintf(stderr, "bench-selection: %s\n", what);
    exit(71);
}

static void hear_part(void *self, const fmb_features *f, const fmb_reduced_part *reduced)
{
    heard *h = self;
    if (!reduced->rest || (h->any && h->entries >= f->entries))
        return;
    h->any = true;
    h->entries = f->entries;
    h->simulated = simulate_elimination(&reduced->e, reduced->drop);
    for (int k = 0; k < FMB_FEATURE_COUNT; k++)
        h->value[k] = fmb_features_value(f, (fmb_feature_id)k);
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
#define LONG_ENOUGH 0.006 /* [s] */
#define MOST_RUNS   4
/* An arm that takes so many times as long as another one, and so long, is not waited for. */
#define FAR_BEHIND 4
#define LEAST_WAIT 0.01 /* [s] */

static double time_arm(int arm, const fmb_system *s, const int *keep, int kept, double seconds)
{
    fmb_options o = {
        .size = sizeof o,
    };
    fmb_solver *v;
    o.evidence = FMB_EVIDENCE_NONE;
    fmb_selection_forced = arm - 1;
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
    printf("\"features\": {");
    for (int k = 0; k < FMB_FEATURE_COUNT; k++)
        printf("%s\"%s\": %g", k > 0 ? ", " : "", fmb_features_name((fmb_feature_id)k),
               h->value[k]);
    printf(", \"simulated rows\": %zu, \"simulated pairs\": %zu, "
           "\"variables left by simulation\": %d, \"simulated first growth\": %ld}",
           h->simulated.most, h->simulated.pairs, h->simulated.left, h->simulated.first);
}

static double limit_behind(double least, double seconds)
{
    double limit = FAR_BEHIND * least < LEAST_WAIT ? LEAST_WAIT : FAR_BEHIND * least;
    return limit < seconds ? limit : seconds;
}

/* took[arm]: [s], or minus the time after which it was not waited for. */
static void time_arms(const fmb_system *s, const int *keep, int kept, double seconds, heard *h,
                      double *took)
{
    double least = seconds;
    fmb_features_watch = (fmb_features_watcher){hear_part, h};
    (void)time_arm(0, s, keep, kept, seconds > 0 ? seconds : LEAST_WAIT);
    fmb_features_watch = (fmb_features_watcher){NULL, NULL};
    for (int arm = 0; h->any && seconds > 0 && arm < count_arms(); arm++) {
        double limit = limit_behind(least, seconds);
        took[arm] = time_arm(arm, s, keep, kept, limit);
        if (took[arm] < 0)
            took[arm] = -limit;
        else if (took[arm] < least)
            least = took[arm];
    }
}

/* What no way is chosen for is left out. */
static void study_problem(const char *family, int digits, uint64_t seed, const fmb_system *s,
                          int kept, double seconds)
{
    int *keep = malloc((size_t)kept * sizeof *keep);
    heard h = {.any = false};
    double took[MOST_ARMS];
    if (!keep)
        fail("no memory");
    for (int k = 0; k < kept; k++)
        keep[k] = k;
    time_arms(s, keep, kept, seconds, &h, took);
    if (h.any) {
        printf("{\"family\": \"%s\", \"digits\": %d, \"seed\": %" PRIu64 ", \"limit\": %g, ",
               family, digits, seed, seconds);
        print_features(&h);
        for (int arm = 0; seconds > 0 && arm < count_arms(); arm++)
            printf("%s\"%s\": %.7f", arm > 0 ? ", " : ", \"took\": {", name_of_arm(arm), took[arm]);
        puts(seconds > 0 ? "}}" : "}");
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
