/* by_enumeration.c: distances, depths and common points of random pairs in the plane and in space,
 * from the library, against enumeration. usage: by_enumeration PAIRS SEED
 *
 * Pair k is the same for any number of threads.
 */
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>
#include <fmb/gmp.h>

#include "enumerate.h"
#include "support/must.h"
#include "support/support.h"

static atomic_int faults;

/* How often there was something to compare. */
static atomic_long apart, deep, flat, polytopes, vertices;

static void expect(bool holds, const char *what, long pair)
{
    if (holds)
        return;
    fprintf(stderr, "pair %ld: %s\n", pair, what);
    faults++;
}

/* ---- pairs ----------------------------------------------------------------------------------- */

/* Two solids, and as frames: numbers are those of the solids over `unit`. */
typedef struct duo {
    solid s[2];
    int unit;
    double origin[2][3], axes[2][9], speed[2][3];
    fmb_frame f[2];
} duo;

static solid draw_solid(support_rng *g, int dim, int unit, int spread)
{
    solid s = {.dim = dim, .naxes = dim, .cuboid = support_chance(g, 50)};
    if (support_chance(g, 25))
        s.naxes = support_between(g, 0, dim);
    bool moves = support_chance(g, 20);
    for (int j = 0; j < dim; j++) {
        s.origin[j] = support_between(g, -spread * unit, spread * unit);
        s.speed[j] = moves ? support_between(g, -3 * unit, 3 * unit) : 0;
        for (int i = 0; i < s.naxes; i++)
            s.edge[i][j] = support_between(g, -3 * unit, 3 * unit);
    }
    return s;
}

/* The solid in doubles, by edges or by corners. */
static void put_frame(duo *d, int k, bool by_corners)
{
    const solid *s = &d->s[k];
    bool moves = false;
    for (int j = 0; j < s->dim; j++) {
        d->origin[k][j] = (double)s->origin[j] / d->unit;
        d->speed[k][j] = (double)s->speed[j] / d->unit;
        moves |= s->speed[j] != 0;
        for (int i = 0; i < s->naxes; i++)
            d->axes[k][i * s->dim + j] =
                (double)(s->edge[i][j] + (by_corners ? s->origin[j] : 0)) / d->unit;
    }
    fmb_shape edges = s->cuboid ? FMB_CUBOID : FMB_SIMPLEX,
              corners = s->cuboid ? FMB_CUBOID_BY_CORNERS : FMB_SIMPLEX_BY_CORNERS;
    d->f[k] = (fmb_frame){.shape = by_corners ? corners : edges,
                          .dim = s->dim,
                          .naxes = s->naxes,
                          .origin = d->origin[k],
                          .axes = d->axes[k],
                          .speed = moves ? d->speed[k] : NULL};
}

/* Coarse ones, which touch often, and finer ones; near, or far apart. */
static void draw_duo(support_rng *g, duo *d)
{
    int dim = support_between(g, 2, 3), spread = support_between(g, 0, 5);
    d->unit = support_chance(g, 50) ? 1 : 8;
    for (int k = 0; k < 2; k++) {
        d->s[k] = draw_solid(g, dim, d->unit, spread);
        put_frame(d, k, support_chance(g, 40));
    }
}

/* ---- answers --------------------------------------------------------------------------------- */

static void set_wide(wide x, mpz_t out)
{
    bool below = x < 0;
    wide size = below ? -x : x;
    mpz_set_ui(out, (unsigned long)(size >> 64));
    mpz_mul_2exp(out, out, 64);
    mpz_add_ui(out, out, (unsigned long)size);
    if (below)
        mpz_neg(out, out);
}

/* x / unit */
static void set_fraction(fraction x, long unit, mpq_t out)
{
    set_wide(x.p, mpq_numref(out));
    set_wide(x.q * unit, mpq_denref(out));
    mpq_canonicalize(out);
}

/* The measure, and the length of the shift, are that. */
static void expect_measure(const fmb_proximity *p, fmb_norm norm, fraction x, long unit,
                           const char *what, long pair)
{
    mpq_t want, got, sum;
    mpq_inits(want, got, sum, NULL);
    set_fraction(x, norm == FMB_NORM_EUCLIDEAN ? unit * unit : unit, want);
    fmb_proximity_measure_q(p, got);
    expect(mpq_equal(want, got), what, pair);
    for (int j = 0; j < fmb_proximity_dim(p); j++) {
        fmb_proximity_shift_q(p, j, got);
        mpq_abs(got, got);
        if (norm == FMB_NORM_EUCLIDEAN) {
            mpq_mul(got, got, got);
            mpq_add(sum, sum, got);
        } else if (mpq_cmp(got, sum) > 0) {
            mpq_set(sum, got);
        }
    }
    expect(mpq_equal(want, sum), "a shift of another length", pair);
    mpq_clears(want, got, sum, NULL);
}

/* The shift is a point of the difference, and on its surface. */
static void expect_touching_after(const fmb_proximity *p, const minkowski *m, long unit, long pair)
{
    bool inside = true, surface = m->flat;
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (int i = 0; i < m->planes; i++) {
        mpq_set_ui(sum, 0, 1);
        for (int j = 0; j < m->dim; j++) {
            fmb_proximity_shift_q(p, j, t);
            mpz_mul_si(mpq_numref(t), mpq_numref(t), unit * m->plane[i].n[j]);
            mpq_canonicalize(t);
            mpq_add(sum, sum, t);
        }
        int beyond = mpq_cmp_si(sum, m->plane[i].c, 1);
        inside &= beyond <= 0;
        surface |= beyond == 0;
    }
    expect(inside && surface, "frames do not touch after the shift", pair);
    mpq_clears(sum, t, NULL);
}

static void compare_distance(fmb_solver *v, const duo *d, const minkowski *m, long pair)
{
    fraction far[2] = {[FMB_NORM_EUCLIDEAN] = enumerate_distance_square(m),
                       [FMB_NORM_MAX] = enumerate_distance_max(m)};
    bool meets = far[FMB_NORM_EUCLIDEAN].p == 0;
    apart += !meets;
    flat += m->flat;
    expect(meets == (far[FMB_NORM_MAX].p == 0), "enumeration contradicts itself", pair);
    for (int norm = 0; norm < 2; norm++) {
        fmb_proximity *p = NULL;
        fmb_result r = {.size = sizeof r};
        must(fmb_distance(v, d->f, (fmb_norm)norm, &p, &r));
        expect(p && r.verdict == (meets ? FMB_FEASIBLE : FMB_INFEASIBLE), "verdict", pair);
        if (p)
            expect_measure(p, (fmb_norm)norm, far[norm], d->unit, "distance", pair);
        if (p && !meets)
            expect_touching_after(p, m, d->unit, pair);
        fmb_proximity_free(p);
    }
}

static void compare_depth(fmb_solver *v, const duo *d, const minkowski *m, bool meets, long pair)
{
    for (int norm = 0; norm < 2; norm++) {
        fmb_proximity *p = NULL;
        fmb_result r = {.size = sizeof r};
        must(fmb_depth(v, d->f, (fmb_norm)norm, &p, &r));
        expect((p != NULL) == meets, "a depth, or none", pair);
        if (p) {
            fraction x =
                norm == FMB_NORM_EUCLIDEAN ? enumerate_depth_square(m) : enumerate_depth_max(m);
            expect_measure(p, (fmb_norm)norm, x, d->unit, "depth", pair);
            expect_touching_after(p, m, d->unit, pair);
            deep += x.p > 0;
        }
        fmb_proximity_free(p);
    }
}

static bool is_vertex(const fmb_generators *g, size_t i, const common_points *all, int k, long unit,
                      int dim)
{
    bool is = true;
    mpq_t want, got;
    mpq_inits(want, got, NULL);
    for (int j = 0; is && j < all->dim; j++) {
        fmb_generators_coordinate_q(g, i, j, got);
        set_fraction((fraction){all->p[k][j], all->q[k]}, j < dim ? unit : 1, want);
        is = mpq_equal(want, got);
    }
    mpq_clears(want, got, NULL);
    return is;
}

static void compare_common(fmb_solver *v, const duo *d, bool meets, long pair)
{
    common_points all;
    fmb_generators *g = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_common(v, d->f, &g, &r));
    expect((g != NULL) == meets, "common points, or none", pair);
    if (g && enumerate_common(&d->s[0], &d->s[1], &all)) {
        expect(fmb_generators_dim(g) == all.dim, "coordinates", pair);
        expect(fmb_generators_size(g) == (size_t)all.n, "number of vertices", pair);
        for (size_t i = 0; i < fmb_generators_size(g); i++) {
            int k = 0;
            while (k < all.n && !is_vertex(g, i, &all, k, d->unit, d->s[0].dim))
                k++;
            expect(k < all.n && fmb_generators_kind(g, i) == FMB_VERTEX, "no such vertex", pair);
        }
        polytopes++;
        vertices += all.n;
    }
    fmb_generators_free(g);
}

/* ---- the run --------------------------------------------------------------------------------- */

static void compare_pair(fmb_solver *v, uint64_t seed, long pair)
{
    support_rng g = {seed * 0x9e3779b97f4a7c15 + (uint64_t)pair};
    duo d;
    minkowski m;
    draw_duo(&g, &d);
    enumerate_difference(&d.s[0], &d.s[1], &m);
    bool meets = enumerate_distance_square(&m).p == 0;
    compare_distance(v, &d, &m, pair);
    compare_depth(v, &d, &m, meets, pair);
    compare_common(v, &d, meets, pair);
}

int main(int argc, char **argv)
{
    long pairs = argc > 1 ? atol(argv[1]) : 1000;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
#ifdef _OPENMP
#pragma omp parallel
#endif
    {
        fmb_solver *v = NULL;
        must(fmb_solver_new(NULL, NULL, &v));
#ifdef _OPENMP
#pragma omp for schedule(dynamic, 16)
#endif
        for (long pair = 0; pair < pairs; pair++)
            if (faults == 0)
                compare_pair(v, seed, pair);
        fmb_solver_free(v);
    }
    printf("%ld pairs: %ld apart, %ld flat, %ld depths, %ld polytopes of %ld vertices, %d faults\n",
           pairs, apart, flat, deep, polytopes, vertices, faults);
    return faults > 0;
}
