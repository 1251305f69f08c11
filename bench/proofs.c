/* proofs.c: the cost of a proof of a projection, relative to the projection without one: that its
 * rows are right, that none is missing, writing and checking both. See README.md.
 *
 * All arms of a problem run one after another in this process, timed by its processor time; short
 * runs are repeated, and the least counts.
 */
#define _DEFAULT_SOURCE /* setitimer */
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>

#include <fmb/fmb.h>

#include "machine.h"
#include "peers/problem.h"
#include "study/program/program.h"
#include "study/program/projection.h"

static const char USAGE[] =
    "usage: bench-proofs [--seed N] [--each N] [--seconds S] [--family NAME] [FILE...]\n"
    "Projections of all families, N seeds of each from --seed on, and the files.\n";

typedef struct bench_plan {
    uint64_t seed, each;
    double seconds;
    const char *family; /* or NULL: all */
} bench_plan;

/* Times of one problem [s]; below 0: not finished. */
typedef struct bench_costs {
    double bare, rows, whole, written, checked;
    size_t corners, bytes;
    bool proved;
    char why[160];
} bench_costs;

/* Of all problems. */
typedef struct bench_totals {
    double bare, rows, whole, checked, worst, worst_checked, logs;
    size_t problems, unproved, beyond, missed;
} bench_totals;

static void fail(const char *what)
{
    fprintf(stderr, "bench-proofs: %s\n", what);
    exit(71);
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

/* Project on the first variables, with that evidence; [s], below 0: not finished. */
static double project_once(fmb_solver *v, const problem *p, double seconds)
{
    fmb_result r = {.size = sizeof r};
    fmb_system *out = NULL;
    int *keep = need(malloc(((size_t)p->keep + 1) * sizeof *keep));
    for (int k = 0; k < p->keep; k++)
        keep[k] = k;
    asked = v;
    end_query_after(seconds);
    double begin = thread_seconds();
    if (fmb_project(v, p->system, keep, p->keep, &out, &r) != FMB_OK)
        fail("a projection failed");
    double end = thread_seconds();
    end_query_after(0);
    fmb_system_free(out);
    free(keep);
    return r.stop == FMB_STOP_DONE ? end - begin : -1;
}

static double write_once(fmb_evidence *e, const problem *p, size_t *bytes)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, bytes);
    double begin = thread_seconds();
    if (!out || fmb_evidence_write(e, p->system, out) != FMB_OK)
        fail("a proof was not written");
    fclose(out);
    double end = thread_seconds();
    free(text);
    return end - begin;
}

static double check_once(fmb_evidence *e, const problem *p)
{
    fmb_judgement j = {.size = sizeof j};
    double begin = thread_seconds();
    if (fmb_check(p->system, e, &j) != FMB_OK || !j.accepted)
        fail("a proof was not accepted");
    return thread_seconds() - begin;
}

/* Short queries are repeated: the least time of up to five counts. */
#define LONG_ENOUGH 0.02 /* [s] */
#define MOST_RUNS   5

static void keep_least(double *least, double now, int run)
{
    if (run == 0 || now < *least)
        *least = now;
}

static void count_corners(const fmb_evidence *e, bench_costs *c)
{
    c->corners = 0;
    c->proved = false;
    for (size_t i = 0; i < fmb_evidence_claims(e); i++) {
        c->corners += fmb_evidence_kind(e, i) == FMB_CLAIM_CORNER;
        c->proved |= fmb_evidence_kind(e, i) == FMB_CLAIM_WHOLE ||
                     fmb_evidence_kind(e, i) == FMB_CLAIM_INFEASIBLE;
    }
}

static void time_evidence(fmb_solver *v, const problem *p, bench_costs *c, int run)
{
    fmb_evidence *e = NULL;
    if (fmb_solver_evidence(v, &e) != FMB_OK)
        fail("there is no evidence");
    count_corners(e, c);
    if (!c->proved)
        snprintf(c->why, sizeof c->why, "%s", fmb_solver_trouble(v));
    keep_least(&c->written, write_once(e, p, &c->bytes), run);
    keep_least(&c->checked, check_once(e, p), run);
    fmb_evidence_free(e);
}

/* The least of a few runs with that evidence. */
static double time_arm(fmb_evidence_kept level, const problem *p, double seconds, bench_costs *c)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v;
    double least = -1, total = 0;
    o.evidence = level;
    if (fmb_solver_new(&o, NULL, &v) != FMB_OK)
        fail("no memory");
    for (int i = 0; i < MOST_RUNS && total < LONG_ENOUGH; i++) {
        double now = project_once(v, p, seconds);
        if (now < 0) {
            least = -1;
            break;
        }
        keep_least(&least, now, i);
        total += now;
        if (level == FMB_EVIDENCE_WHOLE)
            time_evidence(v, p, c, i);
    }
    fmb_solver_free(v);
    return least;
}

#define WORTH_A_RATIO 1e-3 /* [s] */

static void add_to_totals(bench_totals *t, const bench_costs *c)
{
    double ratio = (c->whole + c->written) / c->bare, checked = c->checked / c->bare;
    t->problems++;
    t->unproved += !c->proved;
    t->bare += c->bare;
    t->rows += c->rows;
    t->whole += c->whole + c->written;
    t->checked += c->checked;
    t->logs += log(ratio);
    t->beyond += ratio > 5;
    if (c->bare >= WORTH_A_RATIO && ratio > t->worst)
        t->worst = ratio;
    if (c->bare >= WORTH_A_RATIO && checked > t->worst_checked)
        t->worst_checked = checked;
}

static void ask_problem(const problem *p, const bench_plan *plan, bench_totals *t)
{
    bench_costs c = {.why = ""};
    c.bare = time_arm(FMB_EVIDENCE_NONE, p, plan->seconds, &c);
    if (c.bare < 0) {
        t->missed++;
        return;
    }
    c.rows = time_arm(FMB_EVIDENCE_ALL, p, 60 * plan->seconds, &c);
    c.whole = time_arm(FMB_EVIDENCE_WHOLE, p, 60 * plan->seconds, &c);
    if (c.whole < 0 || c.rows < 0) {
        printf("%s\t%.3f\tnot done with a proof\n", p->name, 1e3 * c.bare);
        t->missed++;
        return;
    }
    printf("%s\t%.3f\t%.2f\t%.2f\t%.2f\t%.2f\t%zu\t%zu\t%s\n", p->name, 1e3 * c.bare,
           c.rows / c.bare, (c.whole + c.written) / c.bare, c.written / c.bare, c.checked / c.bare,
           c.corners, c.bytes, c.proved ? "whole" : c.why);
    fflush(stdout);
    add_to_totals(t, &c);
}

static void ask_family(int family, uint64_t seed, const bench_plan *plan, bench_totals *t)
{
    study_projection drawn;
    problem p;
    char name[sizeof p.name];
    if (study_projection_draw(family, seed, &drawn) != FMB_OK)
        fail("no memory");
    snprintf(name, sizeof name, "%s_%" PRIu64, study_projection_name(family), seed);
    problem_of_system(&p, name, drawn.s);
    p.keep = drawn.keep;
    ask_problem(&p, plan, t);
    problem_clear(&p);
}

static void ask_file(const char *path, const bench_plan *plan, bench_totals *t)
{
    problem p;
    if (!problem_read(&p, path))
        exit(66);
    if (p.keep < p.n)
        ask_problem(&p, plan, t);
    problem_clear(&p);
}

static void print_totals(const bench_totals *t)
{
    printf("%zu problems, %zu not proved whole, %zu not done\n", t->problems, t->unproved,
           t->missed);
    printf("bare %.3f s; proof of rows %.2f, of all %.2f times that, %.2f in the geometric mean; "
           "over 5: %zu; worst from 1 ms on %.2f; check %.2f, worst %.2f\n",
           t->bare, t->rows / t->bare, t->whole / t->bare, exp(t->logs / (double)t->problems),
           t->beyond, t->worst, t->checked / t->bare, t->worst_checked);
}

static bool take_argument(bench_plan *plan, const char *name, const char *value)
{
    if (strcmp(name, "--seed") == 0)
        plan->seed = strtoull(value, NULL, 10);
    else if (strcmp(name, "--each") == 0)
        plan->each = strtoull(value, NULL, 10);
    else if (strcmp(name, "--seconds") == 0)
        plan->seconds = atof(value);
    else if (strcmp(name, "--family") == 0)
        plan->family = value;
    else
        return false;
    return true;
}

int main(int argc, char **argv)
{
    bench_plan plan = {.seed = 1, .each = 1, .seconds = 1};
    bench_totals t = {0};
    int i = 1;
    for (; i < argc && argv[i][0] == '-'; i += 2)
        if (i + 1 >= argc || !take_argument(&plan, argv[i], argv[i + 1])) {
            fputs(USAGE, stderr);
            return 64;
        }
    signal(SIGPROF, end_query);
    puts("problem\tbare [ms]\trows\twhole\twriting\tcheck\tcorners\tbytes\t");
    for (uint64_t seed = plan.seed; seed < plan.seed + plan.each; seed++)
        for (int f = 0; f < study_projections(); f++)
            if (!plan.family || strcmp(plan.family, study_projection_name(f)) == 0)
                ask_family(f, seed, &plan, &t);
    for (; i < argc; i++)
        ask_file(argv[i], &plan, &t);
    print_totals(&t);
    return 0;
}
