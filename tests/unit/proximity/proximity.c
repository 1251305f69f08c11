/* proximity.c: distance, depth and common points of random pairs, by their definitions: corners of
 * the Minkowski difference, and verdicts on moved frames. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>
#include <fmb/gmp.h>

#include "../frame/meet.h"
#include "bodies.h"
#include "property/random/rows.h"

static fmb_solver *solver;

static void open_solver(void)
{
    must(fmb_solver_new(NULL, NULL, &solver));
}

static void close_solver(void)
{
    fmb_solver_free(solver);
}

TestSuite(proximity, .init = open_solver, .fini = close_solver);

/* The shift of an answer, and how long it is. */
typedef struct vector {
    int dim;
    mpq_t x[BODIES_MOST_DIM], square, most, sum;
} vector;

static void measure_vector(vector *u)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(u->square, 0, 1);
    mpq_set_ui(u->most, 0, 1);
    mpq_set_ui(u->sum, 0, 1);
    for (int j = 0; j < u->dim; j++) {
        mpq_mul(t, u->x[j], u->x[j]);
        mpq_add(u->square, u->square, t);
        mpq_abs(t, u->x[j]);
        mpq_add(u->sum, u->sum, t);
        if (mpq_cmp(t, u->most) > 0)
            mpq_set(u->most, t);
    }
    mpq_clear(t);
}

static vector vector_new(int dim)
{
    vector u = {.dim = dim};
    for (int j = 0; j < dim; j++)
        mpq_init(u.x[j]);
    mpq_inits(u.square, u.most, u.sum, NULL);
    return u;
}

static vector shift_of(const fmb_proximity *p, int dim)
{
    vector u = vector_new(dim);
    for (int j = 0; j < dim; j++)
        fmb_proximity_shift_q(p, j, u.x[j]);
    measure_vector(&u);
    return u;
}

static vector draw_vector(support_rng *g, int dim)
{
    vector u = vector_new(dim);
    for (int j = 0; j < dim; j++)
        mpq_set_si(u.x[j], support_between(g, -9, 9), 1);
    measure_vector(&u);
    return u;
}

static void vector_free(vector *u)
{
    for (int j = 0; j < u->dim; j++)
        mpq_clear(u->x[j]);
    mpq_clears(u->square, u->most, u->sum, NULL);
}

static void scale(vector *u, long p, unsigned long q)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_si(t, p, q);
    for (int j = 0; j < u->dim; j++)
        mpq_mul(u->x[j], u->x[j], t);
    measure_vector(u);
    mpq_clear(t);
}

/* Do the frames meet after the second was moved? */
static bool meet_after(const fmb_frame *f, mpq_t *shift)
{
    fmb_frame_q q[2] = {bodies_moved(&f[0], NULL), bodies_moved(&f[1], shift)};
    fmb_system *s = NULL;
    must(fmb_system_from_frames_q(q, 2, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, &s));
    bool yes = is_feasible(s);
    fmb_system_free(s);
    rational_free(&q[0]);
    rational_free(&q[1]);
    return yes;
}

static void expect_measure(const fmb_proximity *p, mpq_srcptr want)
{
    mpq_t got;
    mpq_init(got);
    fmb_proximity_measure_q(p, got);
    cr_expect(mpq_equal(got, want));
    mpq_clear(got);
}

/* A point of an answer belongs to its frame at that time. */
static void expect_inside(const fmb_frame *f, int which, const fmb_proximity *p)
{
    int dim = f->dim;
    fmb_frame_q q[2] = {bodies_moved(&f[which], NULL), rational_new(FMB_CUBOID, dim, 0, false)};
    fmb_system *s = NULL;
    mpq_t t;
    mpq_init(t);
    fmb_proximity_time_q(p, t);
    for (int j = 0; j < dim; j++) {
        mpq_ptr x = q[1].origin[j];
        fmb_proximity_point_q(p, which, j, x);
        if (q[0].speed) {
            mpq_mul(q[0].speed[j], q[0].speed[j], t);
            mpq_sub(x, x, q[0].speed[j]);
            mpq_set_ui(q[0].speed[j], 0, 1);
        }
    }
    must(fmb_system_from_frames_q(q, 2, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, &s));
    cr_expect(is_feasible(s));
    fmb_system_free(s);
    mpq_clear(t);
    rational_free(&q[0]);
    rational_free(&q[1]);
}

/* ---- distance -------------------------------------------------------------------------------- */

/* The plane at right angles to the shift proves that no corner is nearer. */
static void expect_nearest(const fmb_frame *f, const fmb_proximity *p)
{
    difference *m = difference_new(f);
    vector u = shift_of(p, f->dim);
    mpq_t least;
    mpq_init(least);
    expect_measure(p, u.square);
    cr_expect(meet_after(f, u.x));
    difference_least(m, u.x, least);
    cr_expect(mpq_cmp(least, u.square) >= 0);
    expect_inside(f, 0, p);
    expect_inside(f, 1, p);
    mpq_clear(least);
    vector_free(&u);
    difference_free(m);
}

/* No direction proves that it is farther, and in a plane, one proves that it is not nearer: the
 * facets of the difference and of a cube are all those of their sum. */
static void expect_smallest_cube(support_rng *g, const fmb_frame *f, const fmb_proximity *p)
{
    difference *m = difference_new(f);
    vector u = shift_of(p, f->dim);
    mpq_t least, bound;
    mpq_inits(least, bound, NULL);
    expect_measure(p, u.most);
    cr_expect(meet_after(f, u.x));
    for (int round = 0; round < 20; round++) {
        vector w = draw_vector(g, f->dim);
        difference_least(m, w.x, least);
        mpq_mul(bound, u.most, w.sum);
        cr_expect(mpq_cmp(least, bound) <= 0);
        vector_free(&w);
    }
    scale(&u, 999, 1000);
    expect_inside(f, 0, p);
    expect_inside(f, 1, p);
    mpq_clears(least, bound, NULL);
    vector_free(&u);
    difference_free(m);
}

Test(proximity, distances_are_proved_by_corners)
{
    support_rng g = {21};
    int apart = 0;
    for (int round = 0; round < 300; round++) {
        bodies b;
        int dim = support_between(&g, 1, BODIES_MOST_DIM);
        bodies_draw(&g, dim, round % 2 == 0, support_between(&g, 2, 12), &b);
        bool meets = meet(b.f, 2, FMB_COORDINATES_EACH);
        for (fmb_norm norm = FMB_NORM_EUCLIDEAN; norm <= FMB_NORM_MAX; norm++) {
            fmb_proximity *p = NULL;
            fmb_result r = {.size = sizeof r};
            must(fmb_distance(solver, b.f, norm, &p, &r));
            cr_assert(p && r.verdict == (meets ? FMB_FEASIBLE : FMB_INFEASIBLE));
            cr_expect((fmb_proximity_length(p) == 0) == meets);
            if (norm == FMB_NORM_EUCLIDEAN)
                expect_nearest(b.f, p);
            else
                expect_smallest_cube(&g, b.f, p);
            fmb_proximity_free(p);
        }
        apart += !meets;
    }
    cr_expect(apart > 50 && apart < 250, "%d", apart);
}

/* Two squares at a corner: the difference has its nearest point at (2, 1) - (1, 0). */
Test(proximity, distance_of_two_squares)
{
    const double unit[4] = {1, 0, 0, 1}, at[2][2] = {{0, 0}, {4, 5}};
    fmb_frame f[2];
    for (int k = 0; k < 2; k++)
        f[k] =
            (fmb_frame){.shape = FMB_CUBOID, .dim = 2, .naxes = 2, .origin = at[k], .axes = unit};
    fmb_proximity *p = NULL;
    must(fmb_distance(solver, f, FMB_NORM_EUCLIDEAN, &p, NULL));
    cr_expect(fmb_proximity_dim(p) == 2 && fmb_proximity_length(p) == 5);
    cr_expect(fmb_proximity_shift(p, 0) == -3 && fmb_proximity_shift(p, 1) == -4);
    cr_expect(fmb_proximity_point(p, 0, 0) == 1 && fmb_proximity_point(p, 1, 1) == 5);
    cr_expect(fmb_proximity_point(p, 2, 0) == 0 && fmb_proximity_point(p, 0, 2) == 0);
    fmb_proximity_free(p);
    p = NULL;
    must(fmb_distance(solver, f, FMB_NORM_MAX, &p, NULL));
    cr_expect(fmb_proximity_length(p) == 4 && fmb_proximity_time(p) == 0);
    fmb_proximity_free(p);
}

/* ---- depth ----------------------------------------------------------------------------------- */

/* depth = the least over all directions u of (the largest u.m) / |u|: no direction has less. */
static void expect_no_shallower(support_rng *g, const difference *m, fmb_norm norm, mpq_srcptr most)
{
    mpq_t far;
    mpq_init(far);
    for (int round = 0; round < 30; round++) {
        vector u = draw_vector(g, m->dim);
        difference_least(m, u.x, far); /* of u, that is the largest of -u, with its sign */
        mpq_neg(far, far);
        if (norm == FMB_NORM_EUCLIDEAN) {
            mpq_mul(far, far, far);
            mpq_mul(u.square, u.square, most);
            cr_expect(mpq_cmp(far, u.square) >= 0);
        } else {
            mpq_mul(u.sum, u.sum, most);
            cr_expect(mpq_cmp(far, u.sum) >= 0);
        }
        vector_free(&u);
    }
    mpq_clear(far);
}

Test(proximity, depths_part_the_frames)
{
    support_rng g = {22};
    int deep = 0;
    for (int round = 0; round < 160; round++) {
        bodies b;
        int dim = support_between(&g, 1, 3);
        bodies_draw(&g, dim, round % 2 == 0, support_between(&g, 1, 5), &b);
        bool meets = meet(b.f, 2, FMB_COORDINATES_EACH);
        for (fmb_norm norm = FMB_NORM_EUCLIDEAN; norm <= FMB_NORM_MAX; norm++) {
            fmb_proximity *p = NULL;
            fmb_result r = {.size = sizeof r};
            must(fmb_depth(solver, b.f, norm, &p, &r));
            cr_assert((p != NULL) == meets && r.verdict == (meets ? FMB_FEASIBLE : FMB_INFEASIBLE));
            if (!p)
                continue;
            difference *m = difference_new(b.f);
            vector u = shift_of(p, dim);
            expect_measure(p, norm == FMB_NORM_EUCLIDEAN ? u.square : u.most);
            expect_no_shallower(&g, m, norm, norm == FMB_NORM_EUCLIDEAN ? u.square : u.most);
            cr_expect(meet_after(b.f, u.x));
            if (mpq_sgn(u.square) > 0) {
                scale(&u, 1001, 1000);
                cr_expect(!meet_after(b.f, u.x));
                deep++;
            }
            vector_free(&u);
            difference_free(m);
            fmb_proximity_free(p);
        }
    }
    cr_expect(deep > 60, "%d", deep);
}

/* ---- common points --------------------------------------------------------------------------- */

/* The box of the vertices is the box of the common points. */
static void expect_box(const fmb_frame *f, const fmb_generators *g)
{
    fmb_system *s = meeting(f, 2, FMB_COORDINATES_ALL);
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    mpq_t end, x;
    mpq_inits(end, x, NULL);
    must(fmb_bound(solver, s, NULL, 0, &box, &r));
    for (int j = 0; j < 2 * f->dim; j++) {
        fmb_side side = j % 2 ? FMB_UPPER : FMB_LOWER;
        cr_assert(fmb_box_end_q(box, j / 2, side, end));
        int reached = 0;
        for (size_t i = 0; i < fmb_generators_size(g); i++) {
            fmb_generators_coordinate_q(g, i, j / 2, x);
            int beyond = mpq_cmp(x, end);
            cr_expect(side == FMB_UPPER ? beyond <= 0 : beyond >= 0);
            reached += beyond == 0;
        }
        cr_expect(reached > 0);
    }
    mpq_clears(end, x, NULL);
    fmb_box_free(box);
    fmb_system_free(s);
}

/* Every corner of a polygon in the plane turns the same way. */
static void expect_order(const fmb_generators *g)
{
    size_t n = fmb_generators_size(g);
    int turns[2] = {0, 0};
    mpq_t x[6], t;
    mpq_inits(x[0], x[1], x[2], x[3], x[4], x[5], t, NULL);
    for (size_t i = 0; n > 3 && i < n; i++) {
        for (size_t k = 0; k < 6; k++)
            fmb_generators_coordinate_q(g, (i + k / 2) % n, (int)(k % 2), x[k]);
        for (int k = 5; k > 1; k--)
            mpq_sub(x[k], x[k], x[k % 2]);
        mpq_mul(t, x[2], x[5]);
        mpq_mul(x[3], x[3], x[4]);
        turns[mpq_cmp(t, x[3]) > 0]++;
    }
    cr_expect(turns[0] == 0 || turns[1] == 0);
    mpq_clears(x[0], x[1], x[2], x[3], x[4], x[5], t, NULL);
}

Test(proximity, common_points_fill_the_box)
{
    support_rng g = {23};
    int meeting_pairs = 0;
    for (int round = 0; round < 200; round++) {
        bodies b;
        bodies_draw(&g, support_between(&g, 1, 3), round % 2 == 0, support_between(&g, 1, 5), &b);
        bool meets = meet(b.f, 2, FMB_COORDINATES_EACH), moves = b.f[0].speed || b.f[1].speed;
        fmb_generators *common = NULL;
        fmb_result r = {.size = sizeof r};
        must(fmb_common(solver, b.f, &common, &r));
        cr_assert((common != NULL) == meets);
        if (!meets)
            continue;
        cr_expect(fmb_generators_dim(common) == b.f[0].dim + moves);
        for (size_t i = 0; i < fmb_generators_size(common); i++)
            cr_expect(fmb_generators_kind(common, i) == FMB_VERTEX);
        expect_box(b.f, common);
        if (b.f[0].dim == 2 && !moves)
            expect_order(common);
        fmb_generators_free(common);
        meeting_pairs++;
    }
    cr_expect(meeting_pairs > 60, "%d", meeting_pairs);
}

/* Far more ways to write its points than it has vertices. */
Test(proximity, common_points_of_a_hull_of_many)
{
    enum { DIM = 5, POINTS = 40 };
    support_rng g = {24};
    double point[POINTS][DIM], low[DIM], side[DIM][DIM] = {{0}};
    for (int i = 0; i < POINTS * DIM; i++)
        point[i / DIM][i % DIM] = support_between(&g, -9, 9);
    for (int j = 0; j < DIM; j++) {
        low[j] = -4;
        side[j][j] = 8;
    }
    const fmb_frame f[2] = {
        {FMB_SIMPLEX_BY_CORNERS, DIM, POINTS - 1, point[0], point[1], NULL},
        {FMB_CUBOID, DIM, DIM, low, side[0], NULL},
    };
    fmb_generators *common = NULL;
    must(fmb_common(solver, f, &common, NULL));
    cr_assert(common);
    expect_box(f, common);
    fmb_generators_free(common);
}

/* The plane z = x through a cube of side 2: a rectangle with a corner cut off, in its order. */
Test(proximity, polygons_in_space_are_in_order)
{
    const double zero[3] = {0, 0, 0}, cube[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2};
    const double triangle[6] = {4, 0, 4, 0, 3, 0};
    const fmb_frame f[2] = {
        {.shape = FMB_CUBOID, .dim = 3, .naxes = 3, .origin = zero, .axes = cube},
        {.shape = FMB_SIMPLEX, .dim = 3, .naxes = 2, .origin = zero, .axes = triangle}};
    fmb_generators *g = NULL;
    must(fmb_common(solver, f, &g, NULL));
    size_t n = fmb_generators_size(g);
    cr_assert_eq(n, 5);
    for (size_t i = 0; i < n; i++) {
        /* neighbours share one of x = 0, x = 2, y = 0, y = 2, 3 x + 4 y = 12 */
        double x[2], y[2];
        for (size_t k = 0; k < 2; k++) {
            x[k] = fmb_generators_coordinate(g, (i + k) % n, 0);
            y[k] = fmb_generators_coordinate(g, (i + k) % n, 1);
        }
        bool cut = 3 * x[0] + 4 * y[0] > 11.9 && 3 * x[1] + 4 * y[1] > 11.9;
        bool side = x[0] == x[1] && (x[0] == 0 || x[0] == 2);
        cr_expect(cut || side || (y[0] == y[1] && (y[0] == 0 || y[0] == 2)));
    }
    fmb_generators_free(g);
}

Test(proximity, rationals_are_exact)
{
    fmb_frame_q f[2] = {rational_new(FMB_CUBOID, 1, 1, false),
                        rational_new(FMB_SIMPLEX, 1, 1, false)};
    fmb_proximity *p = NULL;
    fmb_generators *common = NULL;
    fmb_system *row = NULL;
    mpq_t third;
    mpq_init(third);
    mpq_set_ui(third, 1, 3);
    mpq_set_ui(f[0].axes[0], 1, 1);
    mpq_set_ui(f[1].origin[0], 4, 3);
    mpq_set_ui(f[1].axes[0], 1, 1);
    must(fmb_distance_q(solver, f, FMB_NORM_MAX, &p, NULL));
    expect_measure(p, third);
    fmb_proximity_free(p);
    p = NULL;
    must(fmb_separate_q(solver, f, FMB_CONTACT_CLOSED, &row, NULL));
    cr_expect(row && fmb_separates_q(f, FMB_CONTACT_CLOSED, row));
    fmb_system_free(row);
    must(fmb_common_q(solver, f, &common, NULL));
    cr_expect_null(common);
    mpq_set_ui(f[1].origin[0], 2, 3);
    must(fmb_depth_q(solver, f, FMB_NORM_EUCLIDEAN, &p, NULL));
    mpq_mul(third, third, third);
    expect_measure(p, third);
    fmb_proximity_point_q(NULL, 0, 0, third);
    cr_expect(mpq_sgn(third) == 0);
    fmb_proximity_free(p);
    mpq_clear(third);
    rational_free(&f[0]);
    rational_free(&f[1]);
}
