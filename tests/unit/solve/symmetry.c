/* symmetry.c: projections of symmetric systems are the same whether the symmetries are used or not,
 * with proofs that do not depend on them. */
#include <criterion/criterion.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/symmetry.h>

#include "canceller.h"
#include "counted_clock.h"
#include "property/random/agree.h"
#include "support.h"

enum { DIM = 8, KEPT = 4 };

/* [give] A few rows around the origin, each with its images under one permutation, which takes
 * variables that are kept to such; now and then a row is without them. */
static fmb_system *with_planted_symmetry(support_rng *g)
{
    fmb_system *s = rows_none(DIM);
    int turn = support_between(g, 1, KEPT - 1), other = support_between(g, 0, KEPT - 1);
    for (int i = 0; i < 9; i++) {
        int64_t a[DIM], next[DIM], b = support_between(g, 5, 60);
        fmb_rel rel = support_chance(g, 10) ? FMB_LT : FMB_LE;
        for (int j = 0; j < DIM; j++)
            a[j] = support_chance(g, 60) ? support_between(g, -5, 5) : 0;
        for (int k = 0; k < KEPT && (k == 0 || !(i == 0 && support_chance(g, 5))); k++) {
            must(fmb_system_add_int(s, a, rel, b));
            for (int j = 0; j < KEPT; j++) {
                next[(j + turn) % KEPT] = a[j];
                next[KEPT + (j + other) % KEPT] = a[KEPT + j];
            }
            memcpy(a, next, sizeof a);
        }
    }
    return s;
}

/* Symmetries are looked for, and used unless the solver's options say no. */
static void find_and_use(fmb_solver *v, const fmb_system *s)
{
    static const int keep[KEPT] = {0, 1, 2, 3};
    fmb_permutations *p = NULL;
    must(fmb_symmetries_find(v, s, keep, KEPT, &p, NULL));
    must(fmb_solver_set_symmetries(v, p));
    fmb_permutations_free(p);
}

/* [give] The projection as text; within so many readings of a counted clock, or, 0, all of it. */
static char *project_with(const fmb_system *s, fmb_symmetries symmetry, size_t threads,
                          size_t seconds, uint64_t *queries)
{
    static const int keep[KEPT] = {0, 1, 2, 3};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_evidence *e = NULL;
    fmb_system *p = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    o.symmetry = symmetry;
    o.threads = threads;
    o.max_seconds = seconds > 0 ? (double)seconds : COUNTED_FOREVER;
    o.method = FMB_METHOD_HULL;
    must(fmb_solver_new(&o, NULL, &v));
    find_and_use(v, s);
    counted_clock_start(0, NULL, NULL);
    must(fmb_project(v, s, keep, KEPT, &p, &r));
    counted_clock_stop();
    cr_assert(p && r.stop == (seconds > 0 ? FMB_STOP_TIME : FMB_STOP_DONE));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted || (seconds > 0 && fmb_evidence_claims(e) == 0), "%s", j.reason);
    must(fmb_system_write(p, FMB_FORMAT_TEXT, f));
    fclose(f);
    *queries += r.stats.lps;
    fmb_evidence_free(e);
    fmb_system_free(p);
    fmb_solver_free(v);
    return text;
}

Test(symmetry, same_projection)
{
    uint64_t none = 0, used = 0, by_three = 0;
    for (uint64_t seed = 0; seed < 6; seed++) {
        support_rng g = {seed * 6700417 + 5};
        fmb_system *s = with_planted_symmetry(&g);
        char *without = project_with(s, FMB_SYMMETRY_NONE, 1, 0, &none);
        char *with = project_with(s, FMB_SYMMETRY_AUTO, 1, 0, &used);
        char *together = project_with(s, FMB_SYMMETRY_AUTO, 3, 0, &by_three);
        cr_assert_str_eq(with, without);
        cr_assert_str_eq(together, without);
        free(without);
        free(with);
        free(together);
        fmb_system_free(s);
    }
#ifdef FMB_HAVE_NAUTY
    cr_assert(used < none, "%llu queries, %llu without", (unsigned long long)used,
              (unsigned long long)none);
#endif
}

/* Images of what is proved are proved when time is up, too. */
Test(symmetry, under_a_limit)
{
    uint64_t queries = 0;
    support_rng g = {77};
    fmb_system *s = with_planted_symmetry(&g);
    for (size_t k = 1; k < 8; k++) {
        free(project_with(s, FMB_SYMMETRY_AUTO, k % 2 + 1, 0, &queries));
        size_t all = counted_clock_readings();
        free(project_with(s, FMB_SYMMETRY_AUTO, k % 2 + 1, all * k / 8, &queries));
    }
    fmb_system_free(s);
}

/* ---- cancelled ------------------------------------------------------------------------------- */

/* [give] The projection by a solver, with its proof judged. */
static fmb_system *project_judged(fmb_solver *v, const fmb_system *s, fmb_result *r)
{
    fmb_evidence *e = NULL;
    fmb_system *p = NULL;
    fmb_judgement j = {.size = sizeof j};
    must(fmb_project(v, s, (int[]){0, 1, 2, 3}, KEPT, &p, r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted || (r->stop != FMB_STOP_DONE && fmb_evidence_claims(e) == 0), "%s",
              j.reason);
    fmb_evidence_free(e);
    return p;
}

/* At whatever event: what is known then is proved, and the solver answers the next question whole.
 */
Test(symmetry, cancelled_at_any_event)
{
    support_rng g = {79};
    fmb_options o = {.size = sizeof o};
    fmb_system *s = with_planted_symmetry(&g);
    canceller c = {NULL, -1};
    size_t rows = 0, cancelled = 0;
    o.method = FMB_METHOD_HULL;
    must(fmb_solver_new(&o, NULL, &c.v));
    find_and_use(c.v, s);
    fmb_solver_set_sink(c.v, (fmb_sink){cancel_at_event, &c});
    for (int k = -1; k < 400; k = k < 40 ? k + 1 : k + 23) {
        fmb_result r = {.size = sizeof r};
        c.events = k;
        fmb_system *p = project_judged(c.v, s, &r);
        cr_expect(r.stop == FMB_STOP_DONE || r.stop == FMB_STOP_CANCELLED);
        cr_expect(r.stop != FMB_STOP_DONE || rows == 0 || fmb_system_rows(p) == rows);
        rows = r.stop == FMB_STOP_DONE ? fmb_system_rows(p) : rows;
        cancelled += r.stop == FMB_STOP_CANCELLED;
        fmb_system_free(p);
    }
    cr_expect(rows > 0 && cancelled > 20, "%zu rows, %zu cancelled", rows, cancelled);
    fmb_solver_free(c.v);
    fmb_system_free(s);
}
