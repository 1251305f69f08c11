/* lift.c: images, sums and hulls of polyhedra: against generators, against the textbook. */
#include <criterion/criterion.h>

#include <string.h>

#include <fmb/lift.h>

#include "preimages.h"
#include "property/random/agree.h"
#include "support.h"

/* ---- by generators --------------------------------------------------------------------------- */

/* v + f w as one more generator: each may be NULL. */
static void add_combination(fmb_generators *to, fmb_generator_kind kind, const fmb_generators *v,
                            size_t i, const fmb_generators *w, size_t k)
{
    mpq_t x[8], y;
    mpq_init(y);
    for (int j = 0; j < fmb_generators_dim(to); j++) {
        mpq_init(x[j]);
        fmb_generators_coordinate_q(v, i, j, x[j]);
        if (w)
            fmb_generators_coordinate_q(w, k, j, y);
        mpq_add(x[j], x[j], y);
    }
    must(fmb_generators_add_q(to, kind, x));
    for (int j = 0; j < fmb_generators_dim(to); j++)
        mpq_clear(x[j]);
    mpq_clear(y);
}

/* [give] All sums of vertices, and the directions of both; both are there. */
static fmb_generators *sum_of_generators(const fmb_generators *a, const fmb_generators *b)
{
    fmb_generators *g = NULL;
    must(fmb_generators_new(fmb_generators_dim(a), NULL, &g));
    for (size_t i = 0; i < fmb_generators_size(a); i++) {
        if (fmb_generators_kind(a, i) != FMB_VERTEX)
            add_combination(g, fmb_generators_kind(a, i), a, i, NULL, 0);
        for (size_t k = 0; k < fmb_generators_size(b); k++)
            if (fmb_generators_kind(a, i) == FMB_VERTEX && fmb_generators_kind(b, k) == FMB_VERTEX)
                add_combination(g, FMB_VERTEX, a, i, b, k);
    }
    for (size_t k = 0; k < fmb_generators_size(b); k++)
        if (fmb_generators_kind(b, k) != FMB_VERTEX)
            add_combination(g, fmb_generators_kind(b, k), b, k, NULL, 0);
    return g;
}

/* [give] Those of both, of which one or both may be NULL. */
static fmb_generators *union_of_generators(int dim, const fmb_generators *a,
                                           const fmb_generators *b)
{
    const fmb_generators *of[2] = {a, b};
    fmb_generators *g = NULL;
    must(fmb_generators_new(dim, NULL, &g));
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < fmb_generators_size(of[k]); i++)
            add_combination(g, fmb_generators_kind(of[k], i), of[k], i, NULL, 0);
    return g;
}

/* A graph over n + m variables, whose forms are not written yet. */
static fmb_system *graph_of(int n, int m)
{
    fmb_system *s = rows_none(n + m);
    return s;
}

/* [give] The images of all under y_i = sum_j form[i][j] x_j / 2 + constant[i]; a ray that comes to
 * nothing stays a ray 0, which generates nothing. */
static fmb_generators *image_of_generators(const fmb_generators *a, int m, int form[][4],
                                           const int *constant)
{
    fmb_generators *g = NULL;
    mpq_t y[4], x, t;
    must(fmb_generators_new(m, NULL, &g));
    mpq_inits(x, t, NULL);
    for (int i = 0; i < m; i++)
        mpq_init(y[i]);
    for (size_t k = 0; k < fmb_generators_size(a); k++) {
        fmb_generator_kind kind = fmb_generators_kind(a, k);
        for (int i = 0; i < m; i++) {
            mpq_set_si(y[i], kind == FMB_VERTEX ? constant[i] : 0, 1);
            for (int j = 0; j < fmb_generators_dim(a); j++) {
                fmb_generators_coordinate_q(a, k, j, x);
                mpq_set_si(t, form[i][j], 2);
                mpq_canonicalize(t);
                mpq_mul(t, t, x);
                mpq_add(y[i], y[i], t);
            }
        }
        must(fmb_generators_add_q(g, kind, y));
    }
    for (int i = 0; i < m; i++)
        mpq_clear(y[i]);
    mpq_clears(x, t, NULL);
    return g;
}

/* Their hull has the same points as the closure of answer, and no row of that is too many. */
static void expect_hull_of(fmb_solver *v, fmb_generators *g, const fmb_system *answer,
                           fmb_verdict verdict, uint64_t seed)
{
    agree a = {.max_rows = 20000};
    fmb_system *expected = NULL, *closed = support_closure(answer);
    fmb_result r = {.size = sizeof r};
    must(fmb_hull(v, g, &expected, &r));
    cr_assert_eq(r.verdict, verdict, "seed %lu", (unsigned long)seed);
    cr_assert(agree_same(&a, closed, expected), "seed %lu: %s", (unsigned long)seed, a.why);
    if (verdict == FMB_FEASIBLE)
        cr_assert(agree_irredundant(&a, answer), "seed %lu: %s", (unsigned long)seed, a.why);
    fmb_system_free(closed);
    fmb_system_free(expected);
    fmb_generators_free(g);
}

/* Two polyhedra with their generators, of any family, small numbers and long ones. */
typedef struct two {
    support_case c[2];
    const fmb_system *s[2];
    fmb_generators *g[2]; /* NULL: empty */
    int dim;
} two;

static two two_at_random(fmb_solver *v, uint64_t seed)
{
    static const int BITS[] = {0, 0, 0, 31, 63};
    support_rng g = {seed};
    fmb_result r = {.size = sizeof r};
    two t = {.dim = support_between(&g, 1, 3)};
    for (int k = 0; k < 2; k++) {
        support_shape shape = {t.dim, support_between(&g, 1, 2 * t.dim + 1), BITS[seed % 5]};
        uint64_t family = (seed + (uint64_t)k * (seed / 5)) % SUPPORT_FAMILIES;
        t.c[k] = support_make((support_family)family, 2 * seed + (uint64_t)k, &shape);
        t.s[k] = t.c[k].s;
        must(fmb_generate(v, t.s[k], &t.g[k], &r));
    }
    return t;
}

static void two_clear(two *t)
{
    for (int k = 0; k < 2; k++) {
        support_case_clear(&t->c[k]);
        fmb_generators_free(t->g[k]);
    }
}

Test(lift, sums_are_hulls_of_sums_of_vertices)
{
    int feasible = 0;
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 200; seed++) {
        two t = two_at_random(v, seed);
        bool full = t.g[0] && t.g[1];
        lifts_answer a = lifts_sum(v, t.s, 2);
        cr_assert_eq(a.verdict, full ? FMB_FEASIBLE : FMB_INFEASIBLE, "%lu", (unsigned long)seed);
        if (full)
            expect_hull_of(v, sum_of_generators(t.g[0], t.g[1]), a.out, FMB_FEASIBLE, seed);
        feasible += full;
        lifts_clear(&a);
        two_clear(&t);
    }
    cr_expect(feasible > 60 && feasible < 180, "%d", feasible);
    fmb_solver_free(v);
}

Test(lift, hulls_of_several_are_hulls_of_all_generators)
{
    int mixed = 0;
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 200; seed++) {
        two t = two_at_random(v, seed);
        bool any = t.g[0] || t.g[1];
        lifts_answer a = lifts_hull(v, t.s, 2);
        cr_assert_eq(a.verdict, any ? FMB_FEASIBLE : FMB_INFEASIBLE);
        expect_hull_of(v, union_of_generators(t.dim, t.g[0], t.g[1]), a.out, a.verdict, seed);
        mixed += any && !(t.g[0] && t.g[1]);
        lifts_clear(&a);
        two_clear(&t);
    }
    cr_expect_gt(mixed, 20);
    fmb_solver_free(v);
}

Test(lift, images_are_hulls_of_images_of_generators)
{
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 200; seed++) {
        support_rng rng = {seed};
        two t = two_at_random(v, seed);
        int m = support_between(&rng, 0, 3), form[4][4], constant[4];
        fmb_system *graph = graph_of(t.dim, m);
        for (int i = 0; i < m; i++) {
            int64_t row[8] = {0};
            constant[i] = support_between(&rng, -3, 3);
            for (int j = 0; j < t.dim; j++)
                row[j] = form[i][j] = support_between(&rng, -2, 2);
            row[t.dim + i] = -2;
            must(fmb_system_add_int(graph, row, FMB_EQ, -2 * constant[i]));
        }
        lifts_answer a = lifts_image(v, t.s[0], graph);
        cr_assert_eq(a.verdict, t.g[0] ? FMB_FEASIBLE : FMB_INFEASIBLE);
        cr_assert_eq(fmb_system_dim(a.out), m);
        if (t.g[0])
            expect_hull_of(v, image_of_generators(t.g[0], m, form, constant), a.out, FMB_FEASIBLE,
                           seed);
        lifts_clear(&a);
        fmb_system_free(graph);
        two_clear(&t);
    }
    fmb_solver_free(v);
}

/* The lift of generators is projected on their hull. */
Test(lift, lifts_of_generators_have_their_hulls_as_shadows)
{
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 100; seed++) {
        two t = two_at_random(v, seed);
        fmb_generators *all = union_of_generators(t.dim, t.g[0], t.g[1]);
        fmb_system *s = NULL;
        must(fmb_lift_generators(all, seed % 2 ? t.s[0] : NULL, &s));
        const fmb_system *one[1] = {s};
        lifts_answer a = lifts_sum(v, one, 1);
        expect_hull_of(v, all, a.out, t.g[0] || t.g[1] ? FMB_FEASIBLE : FMB_INFEASIBLE, seed);
        lifts_clear(&a);
        fmb_system_free(s);
        two_clear(&t);
    }
    fmb_solver_free(v);
}

/* ---- strict rows ----------------------------------------------------------------------------- */

/* [give] {(y, a) : a in A, y - a in B} over 2 n variables, written without any lift: the sum is its
 * projection on y. */
static fmb_system *pairs_that_add_up(const fmb_system *a, const fmb_system *b)
{
    int n = fmb_system_dim(a), map[8];
    fmb_system *s = rows_none(2 * n);
    for (int j = 0; j < n; j++)
        map[j] = n + j;
    rows_append_but(s, a, SIZE_MAX, map);
    for (size_t i = 0; i < fmb_system_rows(b); i++) {
        int var[8];
        mpq_t coef[8], right;
        size_t terms = fmb_system_terms(b, i);
        mpq_init(right);
        fmb_system_rhs_q(b, i, right);
        for (size_t k = 0; k < terms; k++) {
            mpq_inits(coef[k], coef[terms + k], NULL);
            var[k] = fmb_system_term_q(b, i, k, coef[k]);
            var[terms + k] = n + var[k];
            mpq_neg(coef[terms + k], coef[k]);
        }
        must(fmb_system_add_q(s, 2 * terms, var, coef, fmb_system_rel(b, i), right));
        for (size_t k = 0; k < 2 * terms; k++)
            mpq_clear(coef[k]);
        mpq_clear(right);
    }
    return s;
}

Test(lift, sums_are_as_strict_as_the_textbook_says)
{
    int strict = 0, keep[2] = {0, 1};
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 300; seed++) {
        support_shape shape = {1 + (int)(seed % 2), 4, 0};
        agree g = {.max_rows = 20000};
        support_case a = support_make(SUPPORT_MIXED, 2 * seed, &shape);
        support_case b = support_make(SUPPORT_PLANTED_POINT, 2 * seed + 1, &shape);
        const fmb_system *both[2] = {a.s, b.s};
        fmb_system *pairs = pairs_that_add_up(a.s, b.s), *textbook = NULL;
        fmb_verdict verdict = FMB_UNKNOWN;
        must(study_textbook_project(pairs, keep, shape.dim, 20000, &textbook, &verdict));
        lifts_answer s = lifts_sum(v, both, 2);
        cr_assert_eq(s.verdict, verdict);
        if (textbook && verdict == FMB_FEASIBLE) {
            cr_assert(agree_same(&g, s.out, textbook), "seed %lu: %s", (unsigned long)seed, g.why);
            for (size_t i = 0; i < fmb_system_rows(s.out); i++)
                strict += fmb_system_rel(s.out, i) == FMB_LT;
        }
        lifts_clear(&s);
        fmb_system_free(textbook);
        fmb_system_free(pairs);
        support_case_clear(&a);
        support_case_clear(&b);
    }
    cr_expect_gt(strict, 50, "%d", strict);
    fmb_solver_free(v);
}

/* ---- lifts as parts of lifts ----------------------------------------------------------------- */

Test(lift, lifts_are_polyhedra_too)
{
    agree g = {.max_rows = 20000};
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 60; seed++) {
        two t = two_at_random(v, seed);
        lifts_answer h = lifts_hull(v, t.s, 2);
        lifts_answer a = lifts_sum(v, (const fmb_system *[]){h.lift, t.s[1]}, 2);
        lifts_answer b = lifts_sum(v, (const fmb_system *[]){h.out, t.s[1]}, 2);
        cr_assert_eq(a.verdict, b.verdict);
        cr_assert(agree_same(&g, a.out, b.out), "seed %lu: %s", (unsigned long)seed, g.why);
        lifts_clear(&a);
        lifts_clear(&b);
        lifts_clear(&h);
        two_clear(&t);
    }
    fmb_solver_free(v);
}
