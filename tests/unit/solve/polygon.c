/* polygon.c: projections on one or two variables against elimination, and against linear programs
 * in a direction for every vertex. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "support.h"

static fmb_solver *solver(fmb_method method)
{
    return must_open((fmb_options){.method = method, .max_rows = 20000});
}

static bool has(const fmb_system *s, fmb_rel rel)
{
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        if (fmb_system_rel(s, i) == rel)
            return true;
    return false;
}

/* ---- dense systems --------------------------------------------------------------------------- */

static fmb_system *dense_rows(support_rng *g, int n, int m, bool strict)
{
    fmb_system *s = rows_none(n);
    int least = support_chance(g, 30) ? 0 : 5;
    for (int i = 0; i < m; i++) {
        int64_t a[16];
        for (int j = 0; j < n; j++)
            a[j] = support_between(g, -9, 9);
        bool open = strict && support_chance(g, 30);
        must(fmb_system_add_int(s, a, open ? FMB_LT : FMB_LE,
                                support_between(g, open ? 1 : least, 30)));
    }
    return s;
}

/* s with one more variable z = c0 x_k0 + c1 x_k1. */
static fmb_system *with_goal(const fmb_system *s, const int *keep, int n, mpq_t *c, int *z)
{
    fmb_system *t = NULL;
    int var[3];
    mpq_t coef[3], zero;
    must(fmb_system_copy(s, &t));
    must(fmb_system_add_variable(t, NULL, z));
    mpq_inits(coef[0], coef[1], coef[2], zero, NULL);
    for (int k = 0; k < n; k++) {
        var[k] = keep[k];
        mpq_set(coef[k], c[k]);
    }
    var[n] = *z;
    mpq_set_si(coef[n], -1, 1);
    must(fmb_system_add_q(t, (size_t)n + 1, var, coef, FMB_EQ, zero));
    mpq_clears(coef[0], coef[1], coef[2], zero, NULL);
    return t;
}

/* How far c goes. */
static fmb_end reach(const fmb_system *s, const int *keep, int n, mpq_t *c, mpq_t value)
{
    fmb_solver *v = NULL;
    fmb_options o = {.size = sizeof o};
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    int z;
    fmb_system *t = with_goal(s, keep, n, c, &z);
    o.method = FMB_METHOD_LP;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_bound(v, t, &z, 1, &box, &r));
    cr_assert_eq(r.verdict, FMB_FEASIBLE);
    fmb_end end = fmb_box_end(box, 0, FMB_UPPER);
    fmb_box_end_q(box, 0, FMB_UPPER, value);
    fmb_box_free(box);
    fmb_solver_free(v);
    fmb_system_free(t);
    return end;
}

static void check_direction(const fmb_system *s, const fmb_system *p, const int *keep, int n,
                            mpq_t *c)
{
    static const int all[] = {0, 1};
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    fmb_end x = reach(s, keep, n, c, a), y = reach(p, all, n, c, b);
    cr_assert(x.kind == y.kind && x.attained == y.attained && mpq_equal(a, b),
              "another end: %g, %g", x.value, y.value);
    mpq_clears(a, b, NULL);
}

static void read_normal(const fmb_system *p, size_t i, mpq_t *c)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(c[0], 0, 1);
    mpq_set_ui(c[1], 0, 1);
    for (size_t k = 0; k < fmb_system_terms(p, i); k++) {
        int var = fmb_system_term_q(p, i, k, t);
        mpq_set(c[var], t);
    }
    mpq_clear(t);
}

/* A corner of p is farthest in the direction halfway between its two edges. If s goes as far there,
 * p is not too large; and its rows are proved, so it is not too small. */
static void check_corners(const fmb_system *s, const fmb_system *p, const int *keep, int n)
{
    mpq_t c[2], d[2];
    mpq_inits(c[0], c[1], d[0], d[1], NULL);
    for (size_t i = 0; i < fmb_system_rows(p); i++)
        for (size_t k = i; k < fmb_system_rows(p); k++) {
            read_normal(p, i, c);
            read_normal(p, k, d);
            mpq_add(c[0], c[0], d[0]);
            mpq_add(c[1], c[1], d[1]);
            check_direction(s, p, keep, n, c);
        }
    for (int k = 0; k < 4; k++) {
        mpq_set_si(c[0], (k / 2 ? -1 : 1) * (k % 2), 1);
        mpq_set_si(c[1], (k / 2 ? -1 : 1) * (1 - k % 2), 1);
        check_direction(s, p, keep, n, c);
    }
    mpq_clears(c[0], c[1], d[0], d[1], NULL);
}

/* Project with and without evidence; false if that hit a limit. */
static bool check_dense(const fmb_system *s, const int *keep, int n)
{
    agree g = {.max_rows = 5000};
    fmb_solver *v = solver(FMB_METHOD_AUTO);
    fmb_options o = {.size = sizeof o};
    fmb_system *p = NULL, *plain = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_project(v, s, keep, n, &p, &r));
    if (p) {
        cr_assert_eq(r.verdict, FMB_FEASIBLE);
        cr_assert_eq(support_proved_rows(v, s), fmb_system_rows(p));
        cr_assert(agree_irredundant(&g, p), "%s", g.why);
        check_corners(s, p, keep, n);
    }
    fmb_solver_free(v);
    must(fmb_solver_new(&o, NULL, &v));
    if (p) {
        must(fmb_project(v, s, keep, n, &plain, &r));
        cr_assert(agree_same(&g, p, plain), "%s", g.why);
    }
    fmb_system_free(plain);
    fmb_solver_free(v);
    bool judged = p != NULL;
    fmb_system_free(p);
    return judged;
}

Test(polygon, dense_systems)
{
    for (uint64_t seed = 0; seed < 24 / WATCHED; seed++) {
        support_rng g = {seed};
        int n = support_between(&g, 6, 8), m = support_between(&g, 24, 40), i = seed % 2 ? 3 : 0;
        fmb_system *s = dense_rows(&g, n, m, false);
        cr_assert(check_dense(s, (int[]){i, 5}, seed % 5 == 0 ? 1 : 2), "seed %lu",
                  (unsigned long)seed);
        fmb_system_free(s);
    }
}

/* The same, and elimination to compare with. */
Test(polygon, dense_systems_by_elimination)
{
    int judged = 0;
    for (uint64_t seed = 100; seed < 100 + 40 / WATCHED; seed++) {
        support_rng g = {seed};
        agree a = {.max_rows = 5000};
        fmb_system *s = dense_rows(&g, 5, support_between(&g, 16, 24), false), *p[2] = {0};
        for (int k = 0; k < 2; k++) {
            fmb_solver *v = solver(k ? FMB_METHOD_FM : FMB_METHOD_AUTO);
            fmb_result r = {.size = sizeof r};
            must(fmb_project(v, s, (int[]){1, 3}, 2, &p[k], &r));
            fmb_solver_free(v);
        }
        if (p[0] && p[1]) {
            cr_assert(agree_same(&a, p[0], p[1]), "seed %lu: %s", (unsigned long)seed, a.why);
            cr_assert_eq(fmb_system_rows(p[0]), fmb_system_rows(p[1]));
            judged++;
        }
        fmb_system_free(p[0]);
        fmb_system_free(p[1]);
        fmb_system_free(s);
    }
    cr_expect_geq(judged, 30 / WATCHED, "%d judged", judged);
}

/* All rows through one point, which is mostly all there is: no edges. */
Test(polygon, cones)
{
    int points = 0;
    for (uint64_t seed = 300; seed < 316; seed++) {
        support_rng g = {seed};
        int n = support_between(&g, 4, 5);
        fmb_system *s = rows_none(n), *p = NULL;
        fmb_solver *v = solver(FMB_METHOD_AUTO);
        fmb_result r = {.size = sizeof r};
        for (int i = support_between(&g, 14, 22); i > 0; i--) {
            int64_t a[5], b = 0;
            for (int j = 0; j < n; j++) {
                a[j] = support_between(&g, -9, 9);
                b += a[j] * j;
            }
            must(fmb_system_add_int(s, a, FMB_LE, b));
        }
        must(fmb_project(v, s, (int[]){0, 2}, 2, &p, &r));
        cr_assert_eq(r.stop, FMB_STOP_DONE, "seed %lu: %s", (unsigned long)seed,
                     fmb_stop_text(r.stop));
        cr_assert_eq(support_proved_rows(v, s), fmb_system_rows(p));
        check_corners(s, p, (int[]){0, 2}, 2);
        points += has(p, FMB_EQ);
        fmb_system_free(p);
        fmb_solver_free(v);
        fmb_system_free(s);
    }
    cr_expect_gt(points, 8);
}

/* With strict rows elimination has to do it. */
Test(polygon, strict_systems)
{
    int judged = 0;
    for (uint64_t seed = 200; seed < 224; seed++) {
        support_rng g = {seed};
        fmb_system *s = dense_rows(&g, 4, support_between(&g, 14, 22), true);
        judged += check_dense(s, (int[]){1, 3}, seed % 3 == 0 ? 1 : 2);
        fmb_system_free(s);
    }
    cr_expect_geq(judged, 20, "%d judged", judged);
}
