/* second_rays.c: if the estimate of rays is small, double description runs to its end before
 * support queries are tried; if it is large, another engine ends first. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "support.h"

typedef struct shape {
    int dim, keep, rows, missing; /* variables that a row does not name, in turn */
} shape;

/* Around the origin. */
static fmb_system *rows_around_origin(support_rng *g, const shape *k)
{
    fmb_system *s = rows_none(k->dim);
    for (int i = 0; i < k->rows; i++) {
        int64_t a[16];
        for (int j = 0; j < k->dim; j++)
            a[j] = support_between(g, -9, 9);
        for (int j = 0; j < k->missing; j++)
            a[(i + 2 * j) % k->dim] = 0;
        must(fmb_system_add_int(s, a, FMB_LE, support_between(g, 5, 30)));
    }
    return s;
}

static fmb_result project(const fmb_system *s, int keep, fmb_method method, fmb_system **out)
{
    static const int kept[] = {0, 1, 2, 3};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    o.method = method;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, s, kept, keep, out, &r));
    cr_assert_eq(r.verdict, FMB_FEASIBLE);
    fmb_solver_free(v);
    return r;
}

/* Where rays alone bring the projection about, as many pairs of them are looked at as by that
 * method; where they are given up for queries, fewer. */
static void check_pairs(const shape *k, uint64_t seed, bool by_rays_alone)
{
    support_rng g = {seed};
    agree same = {.max_rows = 5000};
    fmb_system *s = rows_around_origin(&g, k), *p = NULL, *q = NULL;
    uint64_t pairs = project(s, k->keep, FMB_METHOD_AUTO, &p).stats.pairs;
    uint64_t all = project(s, k->keep, FMB_METHOD_DD, &q).stats.pairs;
    cr_expect_gt(all, 0);
    cr_expect(by_rays_alone ? pairs == all : pairs < all, "%d to %d, seed %d: %lu of %lu", k->dim,
              k->keep, (int)seed, (unsigned long)pairs, (unsigned long)all);
    cr_expect(agree_same(&same, p, q), "%d to %d, seed %d: %s", k->dim, k->keep, (int)seed,
              same.why);
    fmb_system_free(p);
    fmb_system_free(q);
    fmb_system_free(s);
}

Test(second_rays, end_projections_with_few_rays)
{
    static const shape shapes[] = {{6, 3, 24, 0}, {7, 4, 17, 0}, {8, 4, 18, 0}};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        for (uint64_t seed = 0; seed < 2; seed++)
            check_pairs(&shapes[i], seed, true);
}

Test(second_rays, are_not_made_of_cones_with_many)
{
    for (uint64_t seed = 0; seed < 2; seed += WATCHED)
        check_pairs(&(shape){14, 4, 28, 0}, seed, false);
}
