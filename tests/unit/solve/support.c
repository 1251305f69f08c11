/* support.c: projections by support queries against the ground truth, on systems whose shadows are
 * flat, unbounded, without vertices, of many rows through one point, of wide numbers. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "unit/hull/shadows.h"

typedef struct family {
    const char *name;
    dense (*make)(support_rng *g);
    int count, strict; /* systems; strict rows, of 100 */
} family;

static fmb_solver *solver(fmb_evidence_kept evidence)
{
    fmb_options o = fmb_options_default();
    fmb_solver *v = NULL;
    o.evidence = evidence;
    o.method = FMB_METHOD_HULL;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

/* Some variables, and how many. */
static int choose_kept(support_rng *g, int dim, int *keep)
{
    int n = 0, most = support_between(g, 1, 4);
    for (int j = 0; j < dim && n < most; j++)
        if (support_chance(g, 50) || dim - j == most - n)
            keep[n++] = j;
    return n;
}

static void check_projection(const family *f, int seed, const fmb_system *s, support_rng *g)
{
    agree a = {.max_rows = 2000};
    truth t;
    int keep[6], n = choose_kept(g, fmb_system_dim(s), keep);
    fmb_solver *v = solver(FMB_EVIDENCE_ALL), *plain = solver(FMB_EVIDENCE_NONE);
    fmb_system *p = NULL, *q = NULL;
    fmb_result r;
    truth_init(&t, s, a.max_rows);
    cr_assert(agree_project(&a, v, &t, keep, n, &p), "%s %d: %s", f->name, seed, a.why);
    must(fmb_project(plain, s, keep, n, &q, &r));
    cr_assert(p && q && a.undecided == 0);
    cr_assert(r.stats.rounds == 0, "%s %d: variables were eliminated", f->name, seed);
    cr_assert(agree_same(&a, p, q), "%s %d: %s", f->name, seed, a.why);
    fmb_system_free(p);
    fmb_system_free(q);
    fmb_solver_free(v);
    fmb_solver_free(plain);
    truth_clear(&t);
}

/* Some rows become strict, in so many cases of 100. */
static void make_strict(dense *d, support_rng *g, int percent)
{
    for (int i = 0; i < d->rows; i++)
        if (d->rel[i] == FMB_LE && support_chance(g, percent))
            d->rel[i] = FMB_LT;
}

static void check_family(family f)
{
    for (int seed = 0; seed < f.count; seed++) {
        support_rng g = {(uint64_t)seed * 1000003 + 17};
        dense d = f.make(&g);
        make_strict(&d, &g, f.strict);
        fmb_system *s = dense_system(&d);
        check_projection(&f, seed, s, &g);
        fmb_system_free(s);
        dense_free(&d);
    }
}

Test(support, dense_rows)
{
    check_family((family){"dense rows", shadow_dense_rows, 20, 0});
}

Test(support, bounded)
{
    check_family((family){"bounded", shadow_bounded, 10, 0});
}

Test(support, through_a_point)
{
    check_family((family){"through a point", shadow_through_a_point, 20, 0});
}

Test(support, cones)
{
    check_family((family){"cone", shadow_cone, 20, 0});
}

Test(support, equalities)
{
    check_family((family){"with equalities", shadow_with_equalities, 20, 0});
}

Test(support, flat)
{
    check_family((family){"flat", shadow_flat, 20, 0});
}

Test(support, single_points)
{
    check_family((family){"single point", shadow_single_point, 13, 0});
}

Test(support, cubes_and_the_like)
{
    check_family((family){"cross-polytope", shadow_cross_polytope, 10, 0});
    check_family((family){"pyramid", shadow_pyramid, 10, 0});
}

Test(support, narrow)
{
    check_family((family){"narrow", shadow_narrow, 20, 0});
}

Test(support, unnamed)
{
    check_family((family){"unnamed", shadow_unnamed, 13, 0});
}

/* Many rows meet in one point, so faces of all dimensions may be missing. */
Test(support, strict_rows)
{
    for (int strict = 10; strict <= 90; strict += 40) {
        check_family((family){"bounded", shadow_bounded, 4, strict});
        check_family((family){"through a point", shadow_through_a_point, 15, strict});
        check_family((family){"cone", shadow_cone, 12, strict});
        check_family((family){"with equalities", shadow_with_equalities, 12, strict});
        check_family((family){"cross-polytope", shadow_cross_polytope, 5, strict});
        check_family((family){"pyramid", shadow_pyramid, 16, strict});
        check_family((family){"unnamed", shadow_unnamed, 12, strict});
    }
}

Test(support, wide)
{
    check_family((family){"wide", shadow_wide, 20, 0});
}
