/* project.c: projections of the ground truth: a point is in one exactly if it extends to a
 * solution.
 */
#include <criterion/criterion.h>

#include "fault/hook.h"
#include "study/textbook/exact.h"
#include "support.h"
#include "unit/proof/samples.h"

/* s with variable var[k] fixed at value[k]. */
static fmb_verdict fixed(const fmb_system *s, const int *var, const int *value, int n)
{
    fmb_system *more = NULL;
    fmb_verdict v = FMB_UNKNOWN;
    mpq_t coef[1], rhs;
    mpq_inits(coef[0], rhs, NULL);
    mpq_set_ui(coef[0], 1, 1);
    cr_assert_eq(fmb_system_copy(s, &more), FMB_OK);
    for (int k = 0; k < n; k++) {
        mpq_set_si(rhs, value[k], 2);
        mpq_canonicalize(rhs);
        cr_assert_eq(fmb_system_add_q(more, 1, &var[k], coef, FMB_EQ, rhs), FMB_OK);
    }
    cr_assert_eq(study_textbook_solve(more, 20000, &v), FMB_OK);
    mpq_clears(coef[0], rhs, NULL);
    fmb_system_free(more);
    return v;
}

static void judge(const fmb_system *s, const int *keep, int n, support_rng *g)
{
    static const int place[] = {0, 1, 2, 3};
    fmb_system *p = NULL;
    fmb_verdict v = FMB_UNKNOWN;
    cr_assert_eq(study_textbook_project(s, keep, n, 20000, &p, &v), FMB_OK);
    cr_assert_neq(v, FMB_UNKNOWN);
    cr_assert_eq(fmb_system_dim(p), n);
    for (int k = 0; k < n; k++)
        cr_assert_str_eq(fmb_system_name(p, k), fmb_system_name(s, keep[k]));
    for (int trial = 0; trial < 10; trial++) {
        int value[4];
        for (int k = 0; k < n; k++)
            value[k] = support_between(g, -6, 6);
        fmb_verdict below = fixed(p, place, value, n), above = fixed(s, keep, value, n);
        cr_assert_eq(below, above);
    }
    fmb_system_free(p);
}

Test(project, extends)
{
    support_rng g = {5};
    for (uint64_t seed = 0; seed < 600; seed++) {
        support_family family = (support_family)(seed % SUPPORT_FAMILIES);
        support_shape shape = {.dim = 2 + (int)(seed % 3), .rows = 2 + (int)(seed % 7)};
        support_case c = support_make(family, seed, &shape);
        int first[] = {0}, last[] = {shape.dim - 1}, both[] = {0, shape.dim - 1};
        judge(c.s, first, 1, &g);
        judge(c.s, last, 1, &g);
        judge(c.s, both, 2, &g);
        judge(c.s, both, 0, &g);
        support_case_clear(&c);
    }
}

/* Eliminating two variables at once or one after the other comes to the same. */
Test(project, of_a_projection)
{
    fmb_system *s = proof_system("x y z\n1 1 1 <= 3\n-1 1 0 < 0\n1 -2 1 = 1\n0 0 -1 <= 0", NULL),
               *xy = NULL, *x = NULL, *direct = NULL;
    fmb_verdict v = FMB_UNKNOWN;
    study_textbook_end a[2], b[2];
    int keep[] = {0, 1};
    cr_assert_eq(study_textbook_project(s, keep, 2, 0, &xy, &v), FMB_OK);
    cr_assert_eq(study_textbook_project(xy, keep, 1, 0, &x, &v), FMB_OK);
    cr_assert_eq(study_textbook_project(s, keep, 1, 0, &direct, &v), FMB_OK);
    for (int side = 0; side < 2; side++)
        mpq_inits(a[side].value, b[side].value, NULL);
    cr_assert_eq(study_textbook_bound(x, 0, 0, a, &v), FMB_OK);
    cr_assert_eq(study_textbook_bound(direct, 0, 0, b, &v), FMB_OK);
    for (int side = 0; side < 2; side++) {
        cr_expect(a[side].kind == b[side].kind && a[side].attained == b[side].attained);
        cr_expect(a[side].kind != FMB_END_FINITE || mpq_equal(a[side].value, b[side].value));
        mpq_clears(a[side].value, b[side].value, NULL);
    }
    fmb_system_free(s);
    fmb_system_free(xy);
    fmb_system_free(x);
    fmb_system_free(direct);
}

/* The k-th allocation fails, for every k. */
Test(project, memory)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    int keep[] = {0, 1};
    fmb_system *s =
        proof_system("x y z\n1 1 1 <= 3\n-1 1 0 < 0\n1 -2 1 = 1\n0 0 -1 <= 0\n0 0 1 <= 4", &mem);
    size_t before = h.live;
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        fmb_system *out = NULL;
        fmb_verdict v = FMB_UNKNOWN;
        hook_arm(&h, k, k % 2 == 0);
        st = study_textbook_project(s, keep, 2, 0, &out, &v);
        hook_calm(&h);
        cr_assert((st == FMB_OK) == (out != NULL) && (st == FMB_OK) == (v == FMB_FEASIBLE));
        cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY);
        fmb_system_free(out);
        cr_assert_eq(h.live, before, "request %zu leaks", k);
    }
    fmb_system_free(s);
    cr_assert_eq(h.live, 0);
}
