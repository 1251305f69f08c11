/* main.c: the quality of interrupted projections. See ../README.md.
 *
 * A problem is projected completely, and then with limits that are shares of the processor time of
 * that run. Two measures of an outer projection: the share of the true facets among its rows, and
 * its width along random directions, relative to the true projection. The library computes both: in
 * its canonical form equal facets are equal rows, and its exact optima give the widths.
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <fmb/fmb.h>

#include "../machine.h"
#include "study/program/projection.h"
#include "study/program/random.h"
#include "system/system_private.h"

static const char USAGE[] =
    "usage: bench-anytime [--seed N] [--method auto|fm|dd|hull] [--family NAME] [--seconds S]\n"
    "                     [--csv FILE]\n"
    "Ten hard projections, cut short at shares of the processor time that the whole takes.\n";

/* Families of projections, and the growth of their sizes (projection.h). */
static const struct {
    const char *family;
    int larger;
} PROBLEM[] = {
    {"dense", 4}, {"wide", 4},     {"long", 3},   {"equal", 5}, {"relu", 3},
    {"sum", 8},   {"zonotope", 8}, {"parity", 4}, {"union", 3}, {"control", 2},
};

enum { PROBLEMS = sizeof PROBLEM / sizeof *PROBLEM };

/* Shares of the full time; the first one leaves time for almost nothing. */
static const double SHARE[] = {1e-9, 0.03, 0.1, 0.3, 0.6};

/* [s] Faster problems are not hard. */
#define HARD 0.05

enum { SHARES = sizeof SHARE / sizeof *SHARE, DIRECTIONS = 40, MOST_KEPT = 16 };

typedef struct setup {
    uint64_t seed;
    double seconds; /* a problem that takes longer is drawn anew */
    fmb_options options;
    FILE *csv;
} setup;

/* A problem, and its projection. */
typedef struct subject {
    const char *family;
    uint64_t seed;
    study_projection drawn;
    fmb_system *whole;
    double seconds;
    double width[DIRECTIONS]; /* 0 or infinite: that direction does not count */
} subject;

/* The quality of an outer projection. */
typedef struct worth {
    size_t rows, found; /* of the outer projection; facets among them */
    double width,
        tight; /* means over directions: outer by true (infinite if one is), true by outer */
    fmb_stop stop;
} worth;

static void need(fmb_status st)
{
    if (st == FMB_OK)
        return;
    fprintf(stderr, "bench-anytime: %s\n", fmb_status_text(st));
    exit(71);
}

/* Makes the monotonic clock, which the library's time limits use, show this program's processor
 * time: the program's symbol precedes that of the C library. */
int clock_gettime(clockid_t clock, struct timespec *t)
{
    return (int)syscall(SYS_clock_gettime,
                        clock == CLOCK_MONOTONIC ? CLOCK_PROCESS_CPUTIME_ID : clock, t);
}

/* ---- widths ---------------------------------------------------------------------------------- */

static double farthest(fmb_solver *v, const fmb_system *s, const double *coef, fmb_sense sense)
{
    fmb_optimum *o = NULL;
    fmb_result r = {.size = sizeof r};
    need(fmb_optimize(v, s, &(fmb_objective){sense, coef, 0}, &o, &r));
    double value = fmb_optimum_end(o).kind == FMB_END_INFINITE ? INFINITY : fmb_optimum_nearest(o);
    fmb_optimum_free(o);
    return value;
}

/* Widths along each of the directions, which depend only on the number of variables. */
static void measure_widths(const fmb_system *s, double *width)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    study_random g = {17};
    o.evidence = FMB_EVIDENCE_NONE;
    need(fmb_solver_new(&o, NULL, &v));
    need(fmb_solver_load(v, s));
    for (int d = 0; d < DIRECTIONS; d++) {
        double coef[MOST_KEPT];
        for (int j = 0; j < fmb_system_dim(s); j++)
            coef[j] = (double)study_random_between(&g, -9, 9);
        const fmb_system *loaded = fmb_solver_system(v);
        double most = farthest(v, loaded, coef, FMB_SENSE_MAX);
        double least = farthest(v, loaded, coef, FMB_SENSE_MIN);
        width[d] = isinf(most) || isinf(least) ? INFINITY : most - least;
    }
    fmb_solver_free(v);
}

static void compare_widths(const subject *p, const fmb_system *outer, worth *w)
{
    double width[DIRECTIONS];
    int n = 0;
    w->width = w->tight = 0;
    measure_widths(outer, width);
    for (int d = 0; d < DIRECTIONS; d++) {
        if (!(p->width[d] > 0) || isinf(p->width[d]))
            continue;
        w->width += width[d] / p->width[d];
        w->tight += p->width[d] / width[d];
        n++;
    }
    w->width /= n;
    w->tight /= n;
}

/* ---- projections ----------------------------------------------------------------------------- */

static fmb_system *project(const setup *u, const fmb_system *s, int keep, double limit,
                           double *seconds, fmb_stop *stop)
{
    int kept[MOST_KEPT];
    fmb_options o = u->options;
    fmb_solver *v = NULL;
    fmb_system *out = NULL;
    fmb_result r = {.size = sizeof r};
    for (int j = 0; j < keep; j++)
        kept[j] = j;
    o.max_seconds = limit;
    need(fmb_solver_new(&o, NULL, &v));
    double begin = thread_seconds();
    need(fmb_project(v, s, kept, keep, &out, &r));
    *seconds = thread_seconds() - begin;
    *stop = r.stop;
    fmb_solver_free(v);
    return out;
}

static bool is_bounded_somewhere(const subject *p)
{
    for (int d = 0; d < DIRECTIONS; d++)
        if (p->width[d] > 0 && !isinf(p->width[d]))
            return true;
    return false;
}

/* The first problem from that seed on that is hard, but not too hard, and has a width. */
static void draw_subject(const setup *u, const char *name, int larger, subject *p)
{
    int family = 0;
    fmb_stop stop;
    while (strcmp(study_projection_name(family), name) != 0)
        family++;
    *p = (subject){.family = name, .seed = u->seed};
    for (;; p->seed++) {
        need(study_projection_draw_larger(family, p->seed, larger, &p->drawn));
        if (p->drawn.keep <= MOST_KEPT) {
            p->whole = project(u, p->drawn.s, p->drawn.keep, u->seconds, &p->seconds, &stop);
            if (stop == FMB_STOP_DONE && p->seconds >= HARD) {
                measure_widths(p->whole, p->width);
                if (is_bounded_somewhere(p))
                    return;
            }
            fmb_system_free(p->whole);
        }
        fmb_system_free(p->drawn.s);
    }
}

/* ---- what is found --------------------------------------------------------------------------- */

/* The canonical form: equal sets have the same rows in the same order. */
static fmb_system *make_canonical(const fmb_system *s)
{
    double seconds;
    fmb_stop stop;
    const setup plain = {.options = {.size = sizeof(fmb_options)}};
    return project(&plain, s, fmb_system_dim(s), 0, &seconds, &stop);
}

static size_t count_common_rows(const fmb_system *a, const fmb_system *b)
{
    size_t common = 0;
    for (size_t i = 0, k = 0; i < fmb_system_rows(a) && k < fmb_system_rows(b);) {
        int order = fmb_sysrow_compare(fmb_system_row(a, i), fmb_system_row(b, k));
        common += order == 0;
        i += order <= 0;
        k += order >= 0;
    }
    return common;
}

static worth cut_short(const setup *u, const subject *p, double share)
{
    worth w = {.rows = 0};
    double seconds;
    fmb_system *outer =
        project(u, p->drawn.s, p->drawn.keep, share * p->seconds, &seconds, &w.stop);
    fmb_system *canonical = make_canonical(outer);
    w.rows = fmb_system_rows(outer);
    w.found = count_common_rows(p->whole, canonical);
    compare_widths(p, outer, &w);
    fmb_system_free(canonical);
    fmb_system_free(outer);
    return w;
}

/* ---- the table ------------------------------------------------------------------------------- */

static void print_head(FILE *csv)
{
    printf("%-10s %6s %4s %7s %8s |", "problem", "seed", "kept", "facets", "time");
    for (int i = 0; i < SHARES; i++)
        printf(" %*.0f %%%*s |", 5, 100 * SHARE[i], 12, "");
    printf("\n%40s|", "");
    for (int i = 0; i < SHARES; i++)
        printf(" %5s %6s %6s |", "rows", "found", "width");
    putchar('\n');
    if (csv)
        fputs("problem,seed,kept,facets,seconds,share,rows,found,width,tight\n", csv);
}

static void study_problem(const setup *u, const char *name, int larger, double *sum)
{
    subject p;
    draw_subject(u, name, larger, &p);
    size_t facets = fmb_system_rows(p.whole);
    printf("%-10s %6" PRIu64 " %4d %7zu %7.2fs |", name, p.seed, p.drawn.keep, facets, p.seconds);
    for (int i = 0; i < SHARES; i++) {
        worth w = cut_short(u, &p, SHARE[i]);
        double found = (double)w.found / (double)facets;
        printf(" %5zu %5.0f%% %6.2f |", w.rows, 100 * found, w.width);
        fflush(stdout);
        sum[2 * i] += found / PROBLEMS;
        sum[2 * i + 1] += w.tight / PROBLEMS;
        if (u->csv)
            fprintf(u->csv, "%s,%" PRIu64 ",%d,%zu,%.4f,%g,%zu,%zu,%g,%.5f\n", name, p.seed,
                    p.drawn.keep, facets, p.seconds, SHARE[i], w.rows, w.found, w.width, w.tight);
    }
    putchar('\n');
    fmb_system_free(p.whole);
    fmb_system_free(p.drawn.s);
}

static bool read_option(setup *u, const char *name, const char *value, const char **only)
{
    if (!*value)
        return false;
    if (strcmp(name, "--seed") == 0)
        u->seed = strtoull(value, NULL, 10);
    else if (strcmp(name, "--seconds") == 0)
        u->seconds = atof(value);
    else if (strcmp(name, "--family") == 0)
        *only = value;
    else if (strcmp(name, "--csv") == 0)
        return (u->csv = fopen(value, "w")) != NULL;
    else
        return strcmp(name, "--method") == 0 &&
               fmb_options_set(&u->options, "method", value) == FMB_OK;
    return true;
}

int main(int argc, char **argv)
{
    setup u = {.seed = 1, .seconds = 2, .options = {.size = sizeof(fmb_options)}};
    const char *only = NULL;
    double sum[2 * SHARES] = {0};
    for (int i = 1; i < argc; i += 2)
        if (!read_option(&u, argv[i], i + 1 < argc ? argv[i + 1] : "", &only))
            return fputs(USAGE, stderr), 64;
    print_head(u.csv);
    for (int i = 0; i < PROBLEMS; i++)
        if (!only || strcmp(only, PROBLEM[i].family) == 0)
            study_problem(&u, PROBLEM[i].family, PROBLEM[i].larger, sum);
    printf("%-40s|", "mean share found, and true by outer width");
    for (int i = 0; i < SHARES; i++)
        printf("       %5.0f%% %5.0f%% |", 100 * sum[2 * i], 100 * sum[2 * i + 1]);
    putchar('\n');
    if (u.csv)
        fclose(u.csv);
    return 0;
}
