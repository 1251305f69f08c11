/* main.c: the time of each method of projection on problems of all families, with the features of
 * the problems: one JSON object a line, which fit.py reads. See ../../README.md.
 *
 * An arm is a method, or an engine of the portfolio, or the best engine behind bounded elimination.
 * All arms of a problem run one after another in this process and are timed by its processor time;
 * an arm that exceeds the limit is written as minus the limit.
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

#include "../../peers/problem.h"
#include "base/clock.h"
#include "base/ways.h"
#include "simulate.h"
#include "solve/portfolio/selection.h"
#include "solve/prepare/features.h"
#include "study/program/program.h"
#include "study/program/projection.h"

static const char USAGE[] =
    "usage: bench-selection [--seed N] [--each N] [--seconds S] [--arms auto|singles|engines]\n"
    "                       [--families known|apart|unseen|all] [--more N] [FILE...]\n"
    "Projections of families, N seeds of each, where so many more variables stay than usual,\n"
    "and of files; 0 seconds: features alone.\n";

typedef struct setup {
    uint64_t first, each;
    double seconds;
    bool singles, choice; /* arms: the user's methods, or only the library's choice */
    int more;             /* kept variables than usual */
    int from, to;         /* families */
} setup;

/* The library's choice, then methods that use one engine. */
static const struct {
    const char *name;
    fmb_method method;
} SINGLE[] = {{"auto", FMB_METHOD_AUTO},
              {"elimination", FMB_METHOD_FM},
              {"double description", FMB_METHOD_DD},
              {"support queries", FMB_METHOD_HULL}};

/* Then each engine of the portfolio alone; then the best of them behind bounded elimination. */
static const char *const MORE[] = {
    [FMB_ENGINE_RAYS] = "rays alone",
    [FMB_ENGINE_ELIMINATION] = "pruned elimination alone",
    [FMB_ENGINE_QUERIES] = "queries alone",
    "bounded elimination first",
};

enum { SINGLES = sizeof SINGLE / sizeof *SINGLE, BOUNDED = SINGLES + FMB_ENGINES, MOST_ARMS };

static int count_arms(const setup *u)
{
    return u->choice ? 1 : u->singles ? SINGLES : MOST_ARMS;
}

static const char *name_of_arm(int arm)
{
    return arm < SINGLES ? SINGLE[arm].name : MORE[arm - SINGLES];
}

#define STEP 0.8e-9 /* [s] of a step of work */

/* The engine that ended first, or the first one. */
static int find_best_engine(const double *took)
{
    int best = SINGLES;
    for (int arm = SINGLES; arm < BOUNDED; arm++)
        if (took[arm] >= 0 && (took[best] < 0 || took[arm] < took[best]))
            best = arm;
    return best - SINGLES;
}

/* [steps] An engine with such an estimate runs only after the others gave up, as rays may. */
#define AFTER_ALL 0x1p60

/* The choice of the library if it knew these times. Bounded elimination may take as long as the
 * best engine (lib/trace/run.h). */
static fmb_choice choice_of_arm(int arm, const double *took)
{
    int engine = arm < BOUNDED ? arm - SINGLES : find_best_engine(took);
    fmb_choice c = {.recession = false};
    if (arm == BOUNDED)
        c.bounded = 1 + (uint64_t)(fabs(took[SINGLES + engine]) / STEP);
    for (int k = 0; k < FMB_ENGINES; k++)
        c.work[k] = k == engine ? 1 : AFTER_ALL;
    return c;
}

/* Features of the largest connected part in the events. */
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

/* Other processes disturb the library's limits of wall time: a CPU timer cancels this solver. */
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

/* The answer to a problem as text: all arms must agree. */
static char *answer;

static void compare_answer(const fmb_system *out, fmb_verdict verdict)
{
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    if (!file)
        fail("no memory");
    fprintf(file, "%s\n", fmb_verdict_text(verdict));
    if (out && verdict == FMB_FEASIBLE && fmb_system_write(out, FMB_FORMAT_TEXT, file) != FMB_OK)
        fail("an answer cannot be written");
    fclose(file);
    if (answer && strcmp(answer, text) != 0)
        fail("two arms do not answer the same");
    free(answer);
    answer = text;
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
    if (r.stop == FMB_STOP_DONE)
        compare_answer(out, r.verdict);
    fmb_system_free(out);
    return r.stop == FMB_STOP_DONE ? end - begin : -1;
}

/* Short queries are repeated: the least time of up to five counts. */
#define LONG_ENOUGH 0.006 /* [s] */
#define MOST_RUNS   4
/* An arm is cancelled at FAR_BEHIND times the best time so far, and LEAST_WAIT. */
#define FAR_BEHIND 4
/* Of methods that use one engine only the best one counts. */
#define AS_GOOD    1.1
#define LEAST_WAIT 0.01 /* [s] */

/* [steps] The total steps of the last engine, which resumes where it stopped. */
static void note_steps(void *steps, const fmb_event *e)
{
    if (e->kind == FMB_EVENT_ENGINE && e->attempt->spent > 0)
        *(uint64_t *)steps = e->attempt->spent;
}

static double time_arm(int arm, const fmb_choice *c, const fmb_system *s, const int *keep, int kept,
                       double seconds, uint64_t *steps)
{
    fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_NONE};
    fmb_solver *v;
    if (arm < SINGLES)
        o.method = SINGLE[arm].method;
    fmb_selection_forced = arm < SINGLES ? NULL : c;
    if (fmb_solver_new(&o, NULL, &v) != FMB_OK)
        fail("no memory");
    fmb_solver_set_sink(v, (fmb_sink){note_steps, steps});
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

static double limit_behind(const setup *u, double least)
{
    double limit = fmax((u->singles ? AS_GOOD : FAR_BEHIND) * least, LEAST_WAIT);
    return fmin(limit, u->seconds);
}

typedef struct arm_times {
    double took[MOST_ARMS]; /* [s], or minus the time at which it was cancelled */
    uint64_t steps[MOST_ARMS];
    bool bounded; /* bounded elimination answered */
} arm_times;

static void time_arms(const setup *u, const fmb_system *s, const int *keep, int kept, heard *h,
                      arm_times *t)
{
    const unsigned long long *answered = &fmb_ways_at_hand->answered[FMB_WAY_BOUNDED_GROWTH];
    double *took = t->took;
    double least = u->seconds;
    uint64_t steps = 0;
    fmb_features_watch = (fmb_features_watcher){hear_part, h};
    (void)time_arm(0, NULL, s, keep, kept, u->seconds > 0 ? u->seconds : LEAST_WAIT, &steps);
    fmb_features_watch = (fmb_features_watcher){NULL, NULL};
    for (int arm = 0; h->any && u->seconds > 0 && arm < count_arms(u); arm++) {
        double limit = limit_behind(u, least);
        fmb_choice c = arm < SINGLES ? (fmb_choice){.bounded = 0} : choice_of_arm(arm, took);
        unsigned long long before = *answered;
        took[arm] = time_arm(arm, &c, s, keep, kept, limit, &t->steps[arm]);
        t->bounded = c.bounded > 0 && *answered > before;
        if (took[arm] < 0)
            took[arm] = -limit;
        else if (took[arm] < least)
            least = took[arm];
    }
}

static void print_steps(const arm_times *t)
{
    for (int arm = SINGLES; arm < BOUNDED; arm++)
        printf("%s\"%s\": %" PRIu64, arm > SINGLES ? ", " : "}, \"steps\": {", name_of_arm(arm),
               t->steps[arm]);
}

static void print_times(const setup *u, const arm_times *t)
{
    for (int arm = 0; arm < count_arms(u); arm++)
        printf("%s\"%s\": %.7f", arm > 0 ? ", " : ", \"took\": {", name_of_arm(arm), t->took[arm]);
    if (count_arms(u) == MOST_ARMS)
        print_steps(t);
    if (count_arms(u) == MOST_ARMS)
        printf("}, \"answered\": {\"%s\": %s", name_of_arm(BOUNDED), t->bounded ? "true" : "false");
    putchar('}');
}

/* Skips problems for which the library makes no choice. Takes over s. */
static void study_problem(const setup *u, const char *family, int digits, uint64_t seed,
                          fmb_system *s, int kept)
{
    int *keep = malloc((size_t)kept * sizeof *keep + 1);
    heard h = {.any = false};
    arm_times t = {.bounded = false};
    if (!keep)
        fail("no memory");
    for (int k = 0; k < kept; k++)
        keep[k] = k;
    time_arms(u, s, keep, kept, &h, &t);
    if (h.any) {
        printf("{\"family\": \"%s\", \"digits\": %d, \"seed\": %" PRIu64 ", \"limit\": %g, ",
               family, digits, seed, u->seconds);
        print_features(&h);
        if (u->seconds > 0)
            print_times(u, &t);
        puts("}");
        fflush(stdout);
    }
    free(keep);
    free(answer);
    answer = NULL;
    fmb_system_free(s);
}

/* As they are; as fractions of so many digits; in other units. */
enum { UNITS = -1 };
static const int DIGITS[] = {0, 9, UNITS};

/* Variables and rows are multiplied by powers of 10 up to so many. */
#define MOST_POWER 3

static fmb_status dress_system(const fmb_system *s, int digits, uint64_t seed, fmb_system **out)
{
    return digits == UNITS ? study_system_rescale(s, MOST_POWER, seed, NULL, out)
                           : study_system_fractions(s, digits, seed, out);
}

static void study_family(const setup *u, int family, uint64_t seed, int digits)
{
    study_projection drawn;
    fmb_system *dressed = NULL;
    if (study_projection_draw(family, seed, &drawn) != FMB_OK ||
        (digits != 0 && dress_system(drawn.s, digits, seed, &dressed) != FMB_OK))
        fail("no memory");
    fmb_system *s = dressed ? dressed : drawn.s;
    int most = fmb_system_dim(s) - 2, keep = drawn.keep + u->more;
    if (dressed)
        fmb_system_free(drawn.s);
    study_problem(u, study_projection_name(family), digits, seed, s,
                  u->more == 0 || keep <= most ? keep
                  : drawn.keep <= most         ? most
                                               : drawn.keep);
}

static void study_file(const setup *u, const char *path)
{
    problem p;
    const char *name = strrchr(path, '/');
    if (!problem_read(&p, path))
        fail(path);
    study_problem(u, name ? name + 1 : path, 0, 0, p.system, p.keep);
    p.system = NULL;
    problem_clear(&p);
}

static bool take_option(setup *u, const char *option, const char *value)
{
    int known = study_projections(), apart = known + study_projections_apart();
    int all = apart + study_projections_unseen();
    if (strcmp(option, "--seed") == 0)
        return u->first = strtoull(value, NULL, 10), true;
    if (strcmp(option, "--each") == 0)
        return u->each = strtoull(value, NULL, 10), true;
    if (strcmp(option, "--seconds") == 0)
        return u->seconds = atof(value), true;
    if (strcmp(option, "--more") == 0)
        return u->more = atoi(value), true;
    if (strcmp(option, "--arms") == 0)
        return u->singles = strcmp(value, "singles") == 0, u->choice = strcmp(value, "auto") == 0,
               true;
    u->from = strcmp(value, "apart") == 0 ? known : strcmp(value, "unseen") == 0 ? apart : 0;
    u->to = strcmp(value, "known") == 0 ? known : strcmp(value, "apart") == 0 ? apart : all;
    return strcmp(option, "--families") == 0;
}

int main(int argc, char **argv)
{
    setup u = {.first = 1, .each = 4, .seconds = 1};
    int i = 1;
    u.to = study_projections() + study_projections_apart(); /* the families for fits */
    signal(SIGPROF, end_query);
    for (; i < argc && argv[i][0] == '-'; i += 2)
        if (i + 1 == argc || !take_option(&u, argv[i], argv[i + 1]))
            return fputs(USAGE, stderr), 64;
    for (; i < argc; i++)
        study_file(&u, argv[i]);
    for (uint64_t seed = u.first; seed < u.first + u.each; seed++)
        for (int f = u.from; f < u.to; f++)
            for (size_t k = 0; k < sizeof DIGITS / sizeof *DIGITS; k++)
                study_family(&u, f, seed, DIGITS[k]);
    return 0;
}
