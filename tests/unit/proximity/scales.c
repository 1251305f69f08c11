/* scales.c: depths of pairs with numbers of any digits, near 1e170, 1e-250 and so on, against all
 * separating planes that faces and edges define.
 *
 * The depth is the shortest translation out of the Minkowski difference, across one of its facets:
 * the least h(n) / |n| over the facet normals n, h the support function of the difference. Facets
 * are parallel to a face of A or of B, or to an edge of each; other normals give no smaller value.
 * All in rationals.
 */
#include <criterion/criterion.h>
#include <math.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>
#include <fmb/gmp.h>

#include "support/dense.h"
#include "support/must.h"
#include "support/support.h"

enum { DIM = 3, CORNERS = 8, EDGES = 6 };

/* ---- two bodies ------------------------------------------------------------------------------ */

typedef struct pair_of_bodies {
    double origin[2][DIM], axes[2][DIM * DIM];
    fmb_frame f[2];
} pair_of_bodies;

/* Within -1 ... 1, of 53 bits, times 2^power. */
static double draw_number(support_rng *g, int power)
{
    double high = support_between(g, -(1 << 25), 1 << 25), low = support_between(g, 0, 1 << 26);
    return ldexp(high + ldexp(low, -26), power - 26);
}

/* Their middles are near each other, so that most of them meet. The struct must not move. */
static void draw_pair(support_rng *g, int dim, int power, pair_of_bodies *b)
{
    for (int k = 0; k < 2; k++) {
        fmb_shape shape = support_chance(g, 50) ? FMB_CUBOID : FMB_SIMPLEX;
        for (int j = 0; j < dim * dim; j++)
            b->axes[k][j] = draw_number(g, power);
        for (int j = 0; j < dim; j++) {
            b->origin[k][j] = draw_number(g, power - 2);
            for (int i = 0; i < dim; i++)
                b->origin[k][j] -= b->axes[k][i * dim + j] / (shape == FMB_SIMPLEX ? 4 : 2);
        }
        b->f[k] = (fmb_frame){shape, dim, dim, b->origin[k], b->axes[k], NULL};
    }
}

/* ---- the truth ------------------------------------------------------------------------------- */

/* A body in rationals, by its corners and the directions of its edges. */
typedef struct exact_body {
    int dim, corners, edges;
    mpq_t corner[CORNERS][DIM], edge[EDGES][DIM];
} exact_body;

/* The corners of a simplex: the origin, then the ends of its axes. */
static bool has_axis(const fmb_frame *f, int corner, int axis)
{
    return f->shape == FMB_SIMPLEX ? corner == axis + 1 : corner >> axis & 1;
}

static void take_corners(const fmb_frame *f, exact_body *b)
{
    mpq_t t;
    mpq_init(t);
    b->corners = f->shape == FMB_SIMPLEX ? f->dim + 1 : 1 << f->dim;
    for (int c = 0; c < b->corners; c++)
        for (int j = 0; j < f->dim; j++) {
            mpq_set_d(b->corner[c][j], f->origin[j]);
            for (int i = 0; i < f->dim; i++) {
                mpq_set_d(t, f->axes[i * f->dim + j]);
                if (has_axis(f, c, i))
                    mpq_add(b->corner[c][j], b->corner[c][j], t);
            }
        }
    mpq_clear(t);
}

/* From corner to corner; of a cuboid from the first one. */
static void take_edges(const fmb_frame *f, exact_body *b)
{
    b->edges = 0;
    for (int c = 0; c < b->corners; c++)
        for (int d = 0; d < c; d++) {
            if (f->shape == FMB_CUBOID && (d > 0 || (c & (c - 1)) != 0))
                continue;
            for (int j = 0; j < f->dim; j++)
                mpq_sub(b->edge[b->edges][j], b->corner[c][j], b->corner[d][j]);
            b->edges++;
        }
}

static void open_body(const fmb_frame *f, exact_body *b)
{
    b->dim = f->dim;
    for (int j = 0; j < DIM; j++) {
        for (int c = 0; c < CORNERS; c++)
            mpq_init(b->corner[c][j]);
        for (int e = 0; e < EDGES; e++)
            mpq_init(b->edge[e][j]);
    }
    take_corners(f, b);
    take_edges(f, b);
}

static void close_body(exact_body *b)
{
    for (int j = 0; j < DIM; j++) {
        for (int c = 0; c < CORNERS; c++)
            mpq_clear(b->corner[c][j]);
        for (int e = 0; e < EDGES; e++)
            mpq_clear(b->edge[e][j]);
    }
}

static void dot(int dim, mpq_t *a, mpq_t *b, mpq_t out)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(out, 0, 1);
    for (int j = 0; j < dim; j++) {
        mpq_mul(t, a[j], b[j]);
        mpq_add(out, out, t);
    }
    mpq_clear(t);
}

/* The greatest n.x of b, or the least. */
static void reach_along(exact_body *b, mpq_t *n, bool greatest, mpq_t out)
{
    mpq_t t;
    mpq_init(t);
    for (int c = 0; c < b->corners; c++) {
        dot(b->dim, n, b->corner[c], t);
        if (c == 0 || (mpq_cmp(t, out) > 0) == greatest)
            mpq_set(out, t);
    }
    mpq_clear(t);
}

/* The least depths so far: the square of the Euclidean one, and the other; -1 at first. Negative
 * ways: the two are apart. */
typedef struct least_depth {
    mpq_t square, most;
    bool apart;
} least_depth;

static void lower_to(mpq_t least, const mpq_t x)
{
    if (mpq_sgn(least) < 0 || mpq_cmp(x, least) < 0)
        mpq_set(least, x);
}

/* The way out along n: A goes down along n below B. */
static void note_normal(exact_body *a, exact_body *b, mpq_t *n, least_depth *d)
{
    mpq_t high, low, size;
    mpq_inits(high, low, size, NULL);
    dot(a->dim, n, n, size);
    if (mpq_sgn(size) != 0) {
        reach_along(a, n, true, high);
        reach_along(b, n, false, low);
        mpq_sub(high, high, low);
        d->apart |= mpq_sgn(high) < 0;
        mpq_mul(low, high, high);
        mpq_div(low, low, size);
        lower_to(d->square, low);
        mpq_set_ui(size, 0, 1);
        for (int j = 0; j < a->dim; j++) {
            mpq_abs(low, n[j]);
            mpq_add(size, size, low);
        }
        mpq_div(low, high, size);
        lower_to(d->most, low);
    }
    mpq_clears(high, low, size, NULL);
}

static void note_both_ways(exact_body *a, exact_body *b, mpq_t *n, least_depth *d)
{
    note_normal(a, b, n, d);
    for (int j = 0; j < a->dim; j++)
        mpq_neg(n[j], n[j]);
    note_normal(a, b, n, d);
}

/* n = e x f; in the plane e turned. */
static void cross(int dim, mpq_t *e, mpq_t *f, mpq_t *n)
{
    mpq_t t;
    mpq_init(t);
    for (int j = 0; j < dim; j++) {
        int p = (j + 1) % dim, q = (j + 2) % dim;
        if (dim == 2) {
            mpq_set(n[j], e[1 - j]);
            if (j == 1)
                mpq_neg(n[j], n[j]);
            continue;
        }
        mpq_mul(n[j], e[p], f[q]);
        mpq_mul(t, e[q], f[p]);
        mpq_sub(n[j], n[j], t);
    }
    mpq_clear(t);
}

/* Faces have two edges of one body. */
static void note_all_normals(exact_body b[2], least_depth *d)
{
    mpq_t n[DIM];
    mpq_inits(n[0], n[1], n[2], NULL);
    int all = b[0].edges + b[1].edges;
    for (int e = 0; e < all; e++)
        for (int f = 0; f < (b[0].dim == 2 ? 1 : e); f++) {
            mpq_t *one = e < b[0].edges ? b[0].edge[e] : b[1].edge[e - b[0].edges];
            mpq_t *other = f < b[0].edges ? b[0].edge[f] : b[1].edge[f - b[0].edges];
            cross(b[0].dim, one, other, n);
            note_both_ways(&b[0], &b[1], n, d);
        }
    mpq_clears(n[0], n[1], n[2], NULL);
}

/* ---- the test -------------------------------------------------------------------------------- */

static void expect_depth(fmb_solver *v, const fmb_frame *f, fmb_norm norm, const mpq_t truth,
                         int power)
{
    fmb_proximity *p = NULL;
    mpq_t measure;
    mpq_init(measure);
    must(fmb_depth(v, f, norm, &p, NULL));
    cr_assert(p != NULL);
    fmb_proximity_measure_q(p, measure);
    cr_expect(mpq_equal(measure, truth), "depth of a pair near 2^%d, norm %d", power, (int)norm);
    fmb_proximity_free(p);
    mpq_clear(measure);
}

/* True: they meet. */
static bool check_pair(fmb_solver *v, const fmb_frame *f, int power)
{
    exact_body b[2];
    least_depth d = {.apart = false};
    mpq_inits(d.square, d.most, NULL);
    mpq_set_si(d.square, -1, 1);
    mpq_set_si(d.most, -1, 1);
    open_body(&f[0], &b[0]);
    open_body(&f[1], &b[1]);
    note_all_normals(b, &d);
    if (!d.apart) {
        expect_depth(v, f, FMB_NORM_EUCLIDEAN, d.square, power);
        expect_depth(v, f, FMB_NORM_MAX, d.most, power);
    }
    close_body(&b[0]);
    close_body(&b[1]);
    mpq_clears(d.square, d.most, NULL);
    return !d.apart;
}

/* 1e170, 1e-170, 1e100, 1e-100, 1e250, 1e-250 and 1: 30 pairs of each that meet. */
Test(scales, depths)
{
    static const int POWER[] = {565, -565, 332, -332, 830, -830, 0};
    support_rng g = {3};
    fmb_solver *v = NULL;
    must(fmb_solver_new(NULL, NULL, &v));
    for (size_t i = 0; i < sizeof POWER / sizeof *POWER; i++)
        for (int met = 0, drawn = 0; met < 30; drawn++) {
            pair_of_bodies b;
            cr_assert_lt(drawn, 300);
            draw_pair(&g, drawn % 2 ? 2 : 3, POWER[i], &b);
            met += check_pair(v, b.f, POWER[i]);
        }
    fmb_solver_free(v);
}
