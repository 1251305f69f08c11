/* corners.c: claims about any basis, vertex or point of the plane: which rows it violates, whether
 * it is inside, whether it contradicts a row, whether an edge is unbounded; against small integers.
 */
#include <criterion/criterion.h>

#include "lp/oracle/pivot_walk.h"
#include "lp/oracle/refined_farkas.h"
#include "support/support.h"
#include "vertex_bench.h"

enum { ROWS = 6, ALL = ROWS + 2 };

typedef struct plane {
    vertex_bench b;
    fmb_pivot_walk w;
    int a[ALL][3]; /* rows of the program, then x = 0 and y = 0 */
} plane;

static void draw_row(plane *k, support_rng *g, int i)
{
    mpz_t z[3];
    do
        for (int j = 0; j < 3; j++)
            k->a[i][j] = support_between(g, -4, 4);
    while (k->a[i][0] == 0 && k->a[i][1] == 0);
    for (int j = 0; j < 3; j++)
        mpz_init_set_si(z[j], k->a[i][j]);
    int kind = support_between(g, 0, 4);
    fmb_rel rel = kind == 0 ? FMB_EQ : kind == 1 ? FMB_LT : FMB_LE;
    cr_assert_eq(fmb_program_add_integers(&k->b.p, z, rel), FMB_OK);
    k->b.p.row[i].off = support_chance(g, 10);
    for (int j = 0; j < 3; j++)
        mpz_clear(z[j]);
}

static void open_plane(plane *k, uint64_t seed)
{
    support_rng g = {seed};
    *k = (plane){.a[ROWS] = {1, 0, 0}, .a[ROWS + 1] = {0, 1, 0}};
    vertex_bench_open(&k->b);
    for (int i = 0; i < ROWS; i++)
        draw_row(k, &g, i);
    vertex_bench_stand(&k->b);
    cr_assert_eq(fmb_pivot_walk_init(&k->w, &k->b.v), FMB_OK);
}

static void close_plane(plane *k)
{
    fmb_pivot_walk_clear(&k->w);
    vertex_bench_close(&k->b);
}

/* ---- the truth ------------------------------------------------------------------------------- */

static int sign_of(long x)
{
    return (x > 0) - (x < 0);
}

/* Of b - a.x of row i at x / den. */
static int sign_of_slack(const plane *k, int i, const long *x, long den)
{
    return sign_of(k->a[i][2] * den - k->a[i][0] * x[0] - k->a[i][1] * x[1]);
}

static bool is_row_kept(const plane *k, int i, const long *x, long den, bool strictly)
{
    int sign = sign_of_slack(k, i, x, den);
    fmb_rel rel = k->b.p.row[i].rel;
    return k->b.p.row[i].off ||
           (rel == FMB_EQ ? sign == 0 : sign > (rel == FMB_LT && strictly) - 1);
}

static long determinant(const int *a, const int *b)
{
    return (long)a[0] * b[1] - (long)a[1] * b[0];
}

/* Do rows r and s, times something <= 0 or, of equalities, anything, and row `odd`, times `sign`,
 * add up to 0 < 0? By Cramer's rule. */
static bool do_rows_conflict(const plane *k, const size_t *basis, int odd, int sign)
{
    const int *r = k->a[basis[0]], *s = k->a[basis[1]], *o = k->a[odd];
    long det = determinant(r, s), y[2] = {determinant(o, s) * sign, determinant(r, o) * sign};
    for (int place = 0; place < 2; place++) {
        bool is_loose = basis[place] >= ROWS || k->b.p.row[basis[place]].off;
        bool is_free = !is_loose && k->b.p.row[basis[place]].rel == FMB_EQ;
        int of_y = sign_of(y[place]) * sign_of(det);
        if (is_loose ? of_y != 0 : of_y > 0 && !is_free)
            return false;
    }
    return (sign * o[2] * det - y[0] * r[2] - y[1] * s[2]) * sign_of(det) < 0;
}

static bool is_contradicted(const plane *k, const size_t *basis, int odd)
{
    const fmb_program_row *row = &k->b.p.row[odd];
    bool is_taken = row->off || (size_t)odd == basis[0] || (size_t)odd == basis[1];
    return !is_taken && (do_rows_conflict(k, basis, odd, 1) ||
                         (row->rel == FMB_EQ && do_rows_conflict(k, basis, odd, -1)));
}

/* ---- corners --------------------------------------------------------------------------------- */

static void check_rows_at_vertex(plane *k, const long *x, long den)
{
    size_t first = SIZE_MAX, row;
    bool inside = true;
    int sign;
    for (int i = ROWS; i-- > 0;) {
        cr_assert_eq(fmb_vertex_slack_sign(&k->b.v, (size_t)i), sign_of_slack(k, i, x, den));
        if (!is_row_kept(k, i, x, den, false))
            first = (size_t)i;
        inside = inside && (k->b.p.row[i].rel != FMB_LT || is_row_kept(k, i, x, den, true));
    }
    cr_assert_eq(fmb_vertex_find_violated(&k->b.v, true, &row, &sign), FMB_OK);
    cr_assert_eq(row, first);
    cr_assert(row == SIZE_MAX || sign == -sign_of_slack(k, (int)row, x, den));
    cr_assert_eq(fmb_vertex_is_inside(&k->b.v), inside);
}

/* Exact prices tell whenever there is a conflict. */
static void check_conflict(plane *k, size_t odd, bool truth)
{
    fmb_pivot_walk_end end;
    cr_assert_eq(fmb_pivot_walk_try_conflict(&k->w, odd, &end), FMB_OK);
    cr_assert_eq(end == FMB_PIVOT_WALK_CONFLICT, truth, "row %zu", odd);
    cr_assert(!truth || do_rows_conflict(k, k->b.v.basis, (int)odd, k->w.sign));
}

/* Does the way that was found raise cost, and leave every row kept? */
static bool is_way_free(const plane *k, const int *cost)
{
    const long way[2] = {mpz_get_si(k->w.ray.z[0]), mpz_get_si(k->w.ray.z[1])};
    int den = mpz_sgn(k->w.ray_den);
    bool is_free = sign_of(cost[0] * way[0] + cost[1] * way[1]) * den > 0;
    for (int i = 0; i < ROWS; i++) {
        int sign = sign_of(k->a[i][0] * way[0] + k->a[i][1] * way[1]) * den;
        is_free = is_free &&
                  (k->b.p.row[i].off || sign == 0 || (sign < 0 && k->b.p.row[i].rel != FMB_EQ));
    }
    return is_free;
}

/* Whatever place of the basis is said to be left for ever, or cost to rise. How many are. */
static int count_rays(plane *k)
{
    static const int cost[4][2] = {{1, 0}, {-2, 3}, {0, -1}, {3, 4}};
    int rays = 0;
    for (int c = 0; c < 4; c++)
        for (size_t place = 0; place < 2; place++) {
            mpz_t z[2];
            fmb_pivot_walk_end end;
            mpz_init_set_si(z[0], cost[c][0]);
            mpz_init_set_si(z[1], cost[c][1]);
            cr_assert_eq(fmb_pivot_walk_try_ray(&k->w, place, z, &end), FMB_OK);
            cr_assert(end != FMB_PIVOT_WALK_RAY || is_way_free(k, cost[c]));
            rays += end == FMB_PIVOT_WALK_RAY;
            mpz_clears(z[0], z[1], NULL);
        }
    return rays;
}

/* The number of rows it contradicts. */
static int check_basis(plane *k, const size_t *basis)
{
    int contradicted = 0;
    cr_assert_eq(fmb_vertex_set(&k->b.v, basis), FMB_OK);
    cr_assert_eq(fmb_vertex_solve(&k->b.v), FMB_OK);
    const long x[2] = {mpz_get_si(k->b.v.x.z[0]), mpz_get_si(k->b.v.x.z[1])};
    check_rows_at_vertex(k, x, mpz_get_si(k->b.v.den));
    for (int odd = 0; odd < ROWS; odd++) {
        int sign;
        bool sure, truth = is_contradicted(k, k->b.v.basis, odd);
        cr_assert_eq(fmb_refined_farkas(&k->b.v, (size_t)odd, &sign, &sure), FMB_OK);
        cr_assert(truth || !sure, "row %d", odd);
        cr_assert(!sure || do_rows_conflict(k, k->b.v.basis, odd, sign));
        check_conflict(k, (size_t)odd, truth);
        contradicted += sure;
    }
    return contradicted;
}

/* Bases that are singular, or name rows that are left out, are among them. */
Test(corners, say_what_is_so_of_every_basis)
{
    int contradicted = 0, rays = 0;
    for (uint64_t seed = 0; seed < 200; seed++) {
        plane k;
        open_plane(&k, seed);
        for (size_t i = 0; i < ALL; i++)
            for (size_t j = 0; j < ALL; j++)
                if (i != j) {
                    contradicted += check_basis(&k, (const size_t[]){i, j});
                    rays += count_rays(&k);
                }
        close_plane(&k);
    }
    cr_expect_gt(contradicted, 1000, "%d", contradicted);
    cr_expect_gt(rays, 100, "%d", rays);
}

/* ---- points ---------------------------------------------------------------------------------- */

static void check_point(plane *k, const long *x, long den)
{
    mpz_t z[2], d;
    double roughly[2];
    bool holds, truth = true;
    mpz_init_set_si(z[0], x[0]);
    mpz_init_set_si(z[1], x[1]);
    mpz_init_set_si(d, den);
    for (int i = 0; i < ROWS; i++)
        truth = truth && is_row_kept(k, i, x, den, true);
    cr_assert_eq(fmb_vertex_try_point(&k->b.v, z, d, roughly, &holds), FMB_OK);
    cr_assert_eq(holds, truth, "(%ld, %ld) / %ld", x[0], x[1], den);
    mpz_clears(z[0], z[1], d, NULL);
}

Test(corners, take_points_that_satisfy_all_rows_only)
{
    for (uint64_t seed = 0; seed < 200; seed++) {
        plane k;
        open_plane(&k, seed);
        for (long den = 1; den <= 3; den++)
            for (int code = 0; code < 9 * 9; code++)
                check_point(&k, (const long[]){code % 9 - 4, code / 9 - 4}, den);
        close_plane(&k);
    }
}
