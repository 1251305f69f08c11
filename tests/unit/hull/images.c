/* images.c: projections by double description, through the public interface, against the ground
 * truth: the same solutions, irredundant, every row proved. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "support.h"

static fmb_solver *dd_solver(fmb_arith arith)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.method = FMB_METHOD_DD;
    o.arith = arith;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

static int choose_kept(support_rng *g, int dim, int *keep)
{
    int n = 0;
    for (int j = 0; j < dim; j++)
        if (support_chance(g, 50))
            keep[n++] = j;
    return n;
}

static void check_projections(uint64_t from, uint64_t count, int bits, fmb_arith arith)
{
    agree a = {.max_rows = 2000};
    fmb_solver *v = dd_solver(arith);
    for (uint64_t seed = from; seed < from + count; seed++) {
        support_rng g = {seed};
        support_shape shape = {support_between(&g, 1, 5), support_between(&g, 1, 10), bits};
        support_case c = support_make((support_family)(seed % SUPPORT_FAMILIES), seed, &shape);
        truth t;
        int keep[8], n = choose_kept(&g, shape.dim, keep);
        truth_init(&t, c.s, a.max_rows);
        cr_assert(agree_project(&a, v, &t, keep, n, NULL), "%s, seed %lu: %s",
                  support_family_name(c.family), (unsigned long)seed, a.why);
        truth_clear(&t);
        support_case_clear(&c);
    }
    cr_expect_leq(a.unjudged, a.questions / 10);
    fmb_solver_free(v);
}

Test(images, small_numbers)
{
    check_projections(0, 700, 0, FMB_ARITH_AUTO);
}

Test(images, numbers_of_31_bits)
{
    check_projections(10000, 150, 31, FMB_ARITH_AUTO);
}

Test(images, numbers_beyond_int64)
{
    check_projections(20000, 60, 63, FMB_ARITH_AUTO);
    check_projections(30000, 40, 200, FMB_ARITH_AUTO);
}

Test(images, gmp_only)
{
    check_projections(40000, 150, 0, FMB_ARITH_GMP);
}

/* Many rows through few points, many of them strict: faces of every dimension are excluded. */
static fmb_system *strict_rows(support_rng *g, int dim)
{
    fmb_system *s = rows_none(dim);
    int rows = support_between(g, 2, 9);
    for (int i = 0; i < rows; i++) {
        int64_t a[4];
        for (int j = 0; j < dim; j++)
            a[j] = support_between(g, -1, 1);
        must(fmb_system_add_int(s, a, support_chance(g, 40) ? FMB_LT : FMB_LE,
                                support_chance(g, 70) ? 0 : 1));
    }
    return s;
}

Test(images, faces_that_strict_rows_exclude)
{
    agree a = {.max_rows = 2000};
    fmb_solver *v = dd_solver(FMB_ARITH_AUTO);
    for (uint64_t seed = 50000; seed < 51000; seed++) {
        support_rng g = {seed};
        int dim = support_between(&g, 2, 4), keep[8], n = choose_kept(&g, dim, keep);
        fmb_system *s = strict_rows(&g, dim);
        truth t;
        truth_init(&t, s, a.max_rows);
        cr_assert(agree_project(&a, v, &t, keep, n, NULL), "seed %lu: %s", (unsigned long)seed,
                  a.why);
        truth_clear(&t);
        fmb_system_free(s);
    }
    fmb_solver_free(v);
}
