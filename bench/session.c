/* session.c: the cost of a query after a change: a loaded system (<fmb/session.h>) against a fresh
 * solver on a copy.
 *
 * From a system and its point, one change after another, each of another kind in turn: a bound that
 * the last point violates (branch), that row popped again (pop), a row removed (remove, within a
 * level), a right side moved until the last point is outside (right). After each change both are
 * queried, alternately first; the time is this thread's CPU time with all evidence. The changes
 * themselves are timed apart. See README.md.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/gmp.h>

#include "machine.h"

enum { BRANCH, POP, REMOVE, RIGHT, KINDS };
static const char *const KIND[] = {"branch", "pop", "remove", "right"};

enum { ROUNDS = 24 };

typedef struct bench {
    fmb_solver *v, *fresh;
    double *x; /* the last point */
    unsigned long random;
    double warm[KINDS][ROUNDS], cold[KINDS][ROUNDS], change[KINDS][ROUNDS];
    int unlike;
} bench;

static void must_be_ok(fmb_status st)
{
    if (st == FMB_OK)
        return;
    fprintf(stderr, "bench-session: %s\n", fmb_status_text(st));
    exit(70);
}

static size_t draw_below(bench *b, size_t n)
{
    b->random = b->random * 6364136223846793005u + 1442695040888963407u;
    return (b->random >> 33) % n;
}

static fmb_verdict ask_timed(fmb_solver *v, const fmb_system *s, double *seconds)
{
    fmb_result r = {.size = sizeof r};
    double begin = thread_seconds();
    must_be_ok(fmb_solve(v, s, &r));
    *seconds = thread_seconds() - begin;
    return r.verdict;
}

static void take_point(bench *b, const fmb_system *s)
{
    fmb_evidence *e = NULL;
    must_be_ok(fmb_solver_evidence(b->v, &e));
    for (int j = 0; j < fmb_system_dim(s); j++)
        b->x[j] = fmb_evidence_coordinate(e, 0, j);
    fmb_evidence_free(e);
}

static void ask_both(bench *b, int kind, int round)
{
    const fmb_system *s = fmb_solver_system(b->v);
    fmb_system *copy = NULL;
    fmb_verdict one = FMB_UNKNOWN, other;
    must_be_ok(fmb_system_copy(s, &copy));
    if (round % 2)
        one = ask_timed(b->v, s, &b->warm[kind][round]);
    other = ask_timed(b->fresh, copy, &b->cold[kind][round]);
    if (round % 2 == 0)
        one = ask_timed(b->v, s, &b->warm[kind][round]);
    b->unlike += one != other;
    if (one == FMB_FEASIBLE)
        take_point(b, s);
    fmb_system_free(copy);
}

/* x_j <= its value - 1/2, or >= its value + 1/2 */
static void branch(bench *b)
{
    const fmb_system *s = fmb_solver_system(b->v);
    int j = (int)draw_below(b, (size_t)fmb_system_dim(s));
    int sign = draw_below(b, 2) ? 1 : -1;
    mpq_t one, right;
    mpq_inits(one, right, NULL);
    mpq_set_si(one, sign, 1);
    mpq_set_d(right, floor(2 * sign * b->x[j]) / 2 - 0.5);
    must_be_ok(fmb_solver_push(b->v));
    must_be_ok(fmb_solver_add_q(b->v, 1, &j, &one, FMB_LE, right));
    mpq_clears(one, right, NULL);
}

/* A row's right side becomes a little less than the row is at the last point. */
static void move_right(bench *b)
{
    const fmb_system *s = fmb_solver_system(b->v);
    size_t i = draw_below(b, fmb_system_rows(s));
    double sum = 0;
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int j = fmb_system_term_q(s, i, k, q);
        sum += mpq_get_d(q) * b->x[j];
    }
    mpq_clear(q);
    must_be_ok(fmb_solver_set_right(b->v, i, floor(sum) - 1));
}

static void change(bench *b, int kind)
{
    if (kind == BRANCH) {
        branch(b);
    } else if (kind == POP) {
        must_be_ok(fmb_solver_pop(b->v));
    } else if (kind == REMOVE) {
        must_be_ok(fmb_solver_push(b->v));
        must_be_ok(
            fmb_solver_remove(b->v, draw_below(b, fmb_system_rows(fmb_solver_system(b->v)))));
    } else {
        move_right(b);
    }
}

static void measure_file(bench *b, const char *name, const fmb_system *s)
{
    double ignored;
    must_be_ok(fmb_solver_load(b->v, s));
    b->unlike = 0;
    b->x = calloc((size_t)fmb_system_dim(s) + 1, sizeof *b->x);
    if (!b->x || ask_timed(b->v, fmb_solver_system(b->v), &ignored) != FMB_FEASIBLE) {
        printf("%s: not feasible\n", name);
        free(b->x);
        return;
    }
    take_point(b, s);
    for (int round = 0; round < ROUNDS; round++) {
        for (int kind = 0; kind < KINDS; kind++) {
            double begin = thread_seconds();
            change(b, kind);
            b->change[kind][round] = thread_seconds() - begin;
            ask_both(b, kind, round);
        }
        must_be_ok(fmb_solver_pop(b->v));
    }
    printf("%s, %d unlike\n", name, b->unlike);
    for (int kind = 0; kind < KINDS; kind++) {
        double warm = median(b->warm[kind], ROUNDS), cold = median(b->cold[kind], ROUNDS);
        printf("  %-7s change %7.1f us   then warm %9.1f us   fresh %9.1f us   %6.1f times\n",
               KIND[kind], 1e6 * median(b->change[kind], ROUNDS), 1e6 * warm, 1e6 * cold,
               cold / warm);
    }
    free(b->x);
}

int main(int argc, char **argv)
{
    bench b = {.random = 1};
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_ALL;
    must_be_ok(fmb_solver_new(&o, NULL, &b.v));
    must_be_ok(fmb_solver_new(&o, NULL, &b.fresh));
    for (int k = 1; k < argc; k++) {
        fmb_system *s = NULL;
        fmb_where where;
        FILE *in = fopen(argv[k], "r");
        if (!in || fmb_system_read(in, NULL, &s, &where) != FMB_OK) {
            fprintf(stderr, "bench-session: cannot read %s\n", argv[k]);
            return 66;
        }
        fclose(in);
        const char *slash = strrchr(argv[k], '/');
        measure_file(&b, slash ? slash + 1 : argv[k], s);
        fmb_system_free(s);
    }
    fmb_solver_free(b.v);
    fmb_solver_free(b.fresh);
    return 0;
}
