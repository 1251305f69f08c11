/* contact.c: depths of pairs against those of <fmb/proximity.h>: within the reported error, and no
 * larger along the normal; and all kernels against each other. */
#include <criterion/criterion.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include <fmb/frames.h>
#include <fmb/proximity.h>

#include "property/random/rows.h"
#include "study/draw/pairs.h"
#include "support/support.h"

/* What a depth may be off by, of the reach; and what this file may round, the true depth among it,
 * which is a double. */
#define FUZZ (1e-12L + 8 * LDBL_EPSILON)

/* ---- truth ----------------------------------------------------------------------------------- */

static long double size_of(int dim, const double *x)
{
    long double most = 0;
    for (int j = 0; x && j < dim; j++)
        most = fmaxl(most, fabsl((long double)x[j]));
    return most;
}

static long double reach_of(const fmb_frame *f)
{
    long double sum = 0, shift = 0;
    for (int j = 0; j < f[0].dim; j++)
        shift = fmaxl(shift, fabsl((long double)f[1].origin[j] - f[0].origin[j]));
    for (int k = 0; k < 2; k++) {
        sum += size_of(f[k].dim, f[k].speed);
        for (int i = 0; i < f[k].naxes; i++)
            sum += size_of(f[k].dim, f[k].axes + i * f[k].dim);
    }
    return sum + shift;
}

static long double dot(int dim, const double *n, const double *x)
{
    long double sum = 0;
    for (int j = 0; x && j < dim; j++)
        sum += (long double)n[j] * x[j];
    return sum;
}

/* The largest value (sign 1) of n x over the edges of f, or minus the least (-1). */
static long double farthest(const fmb_frame *f, const double *n, int sign)
{
    long double sum = 0, most = 0;
    for (int i = 0; i < f->naxes; i++) {
        long double at = sign * dot(f->dim, n, f->axes + i * f->dim);
        sum += fmaxl(at, 0);
        most = fmaxl(most, at);
    }
    return f->shape == FMB_SIMPLEX ? most : sum;
}

/* How far the second must go along n so that no point of it is behind one of the first. */
static long double depth_along(const fmb_frame *f, const double *n)
{
    long double away = 0;
    for (int j = 0; j < f->dim; j++)
        away += n[j] * ((long double)f[0].origin[j] - f[1].origin[j]);
    long double drift = dot(f->dim, n, f[0].speed) - dot(f->dim, n, f[1].speed);
    return away + farthest(&f[0], n, 1) + farthest(&f[1], n, -1) + fmaxl(drift, 0);
}

/* ---- a pair ---------------------------------------------------------------------------------- */

enum { ALWAYS_EXACT, TIGHTEST, IN_DOUBLES, WAYS };

typedef struct judge {
    fmb_solver *solver;
    fmb_pair *way[WAYS];
    bool even;  /* numbers are of a size: nothing but what touches is within the fuzz of it */
    bool acute; /* faces may have corners so acute that fuzz reaches far along them */
    int meet, sure, touch; /* pairs that do, whose depth doubles know, that are 0 deep */
} judge;

static judge judge_open(int dim, fmb_simd simd)
{
    judge j = {0};
    cr_assert_eq(fmb_solver_new(NULL, NULL, &j.solver), FMB_OK);
    for (int i = 0; i < WAYS; i++) {
        fmb_pair_options o = {.size = sizeof o, .simd = simd};
        o.method = i == ALWAYS_EXACT ? FMB_PAIR_EXACT : FMB_PAIR_FMB;
        o.tightest = i == TIGHTEST;
        o.doubles_only = i == IN_DOUBLES;
        cr_assert_eq(fmb_pair_new(dim, &o, NULL, &j.way[i]), FMB_OK);
    }
    return j;
}

static void judge_close(judge *j)
{
    fmb_solver_free(j->solver);
    for (int i = 0; i < WAYS; i++)
        fmb_pair_free(j->way[i]);
}

typedef struct said {
    fmb_verdict verdict;
    double depth, normal[3];
    uint8_t faces[2], npoints;
    double points[3 * FMB_PAIR_MOST_POINTS];
} said;

static said ask(fmb_pair *k, const fmb_frame *f)
{
    said s = {.depth = NAN};
    fmb_pair_answers out = {.size = sizeof out, .verdict = &s.verdict};
    out.depth = &s.depth;
    out.normal = s.normal;
    out.faces = s.faces;
    out.points = s.points;
    out.npoints = &s.npoints;
    cr_assert_eq(fmb_pair_test(k, 1, &f[0], &f[1], &out), FMB_OK);
    return s;
}

static void judge_answer(const fmb_frame *f, const said *s, long double truth, const char *name)
{
    long double reach = reach_of(f), length = 0;
    for (int j = 0; j < f->dim; j++)
        length += (long double)s->normal[j] * s->normal[j];
    cr_assert(fabsl(length - 1) < 1e-15L * 4, "%s", name);
    cr_assert(fabsl(s->depth - truth) <= FUZZ * reach + DBL_TRUE_MIN, "%s: %g, not %Lg", name,
              s->depth, truth);
    cr_assert(depth_along(f, s->normal) <= truth + FUZZ * reach + DBL_TRUE_MIN,
              "%s: %Lg along the normal, not %Lg", name, depth_along(f, s->normal), truth);
}

/* ---- where they touch ------------------------------------------------------------------------ */

/* What points may be off by: the fuzz, and rounding in the world. */
static double point_fuzz(const fmb_frame *f)
{
    long double far = 0;
    for (int k = 0; k < 2; k++)
        far = fmaxl(far, size_of(f[k].dim, f[k].origin));
    return (double)(16 * FUZZ * reach_of(f) + 16 * DBL_EPSILON * far + 8 * DBL_TRUE_MIN);
}

/* Every point lies in the first frame, and less the translation in the second. */
static void judge_points(fmb_solver *v, const fmb_frame *f, const said *s, const char *name)
{
    fmb_result res = {.size = sizeof res};
    for (int i = 0; i < s->npoints; i++)
        for (int k = 0; k < 2; k++) {
            double x[3];
            fmb_proximity *p = NULL;
            for (int j = 0; j < f->dim; j++)
                x[j] = s->points[i * f->dim + j] - k * s->depth * s->normal[j];
            fmb_frame two[2] = {f[k], {FMB_CUBOID, f->dim, 0, x, NULL, NULL}};
            cr_assert_eq(fmb_distance(v, two, FMB_NORM_EUCLIDEAN, &p, &res), FMB_OK);
            cr_assert_leq(fmb_proximity_length(p), point_fuzz(f), "%s: point %d of %d in %d", name,
                          i, s->npoints, k);
            fmb_proximity_free(p);
        }
}

/* How far it is from a point to the nearest vertex, and the other way round. */
static double nearest_vertex(const fmb_generators *g, const double *x)
{
    double nearest = INFINITY;
    for (size_t k = 0; k < fmb_generators_size(g); k++) {
        double off = 0;
        for (int j = 0; j < fmb_generators_dim(g); j++)
            off = fmax(off, fabs(x[j] - fmb_generators_coordinate(g, k, j)));
        nearest = fmin(nearest, off);
    }
    return nearest;
}

static double nearest_point(const said *s, const fmb_generators *g, size_t k)
{
    double nearest = INFINITY;
    int dim = fmb_generators_dim(g);
    for (int i = 0; i < s->npoints; i++) {
        double off = 0;
        for (int j = 0; j < dim; j++)
            off = fmax(off, fabs(s->points[i * dim + j] - fmb_generators_coordinate(g, k, j)));
        nearest = fmin(nearest, off);
    }
    return nearest;
}

/* Frames that touch have nothing else in common: the points are the vertices of that, or four of
 * them. */
static void judge_common(fmb_solver *v, const fmb_frame *f, const said *s, const char *name)
{
    fmb_generators *g = NULL;
    fmb_result res = {.size = sizeof res};
    cr_assert_eq(fmb_common(v, f, &g, &res), FMB_OK);
    size_t all = fmb_generators_size(g);
    cr_assert_leq(s->npoints, all < 4 ? all : 4, "%s: %d points of %zu", name, s->npoints, all);
    for (int i = 0; i < s->npoints; i++)
        cr_assert_leq(nearest_vertex(g, s->points + i * f->dim), point_fuzz(f), "%s: point %d",
                      name, i);
    for (size_t k = 0; all <= 4 && k < all; k++)
        cr_assert_leq(nearest_point(s, g, k), point_fuzz(f), "%s: vertex %zu", name, k);
    fmb_generators_free(g);
}

/* The vertices of a face are those that are farthest along the normal. */
static void judge_faces(const fmb_frame *f, const said *s, const char *name)
{
    for (int k = 0; k < 2; k++) {
        bool cuboid = f[k].shape == FMB_CUBOID;
        int sign = k ? -1 : 1;
        long double most = farthest(&f[k], s->normal, sign);
        for (int v = 0; v < (cuboid ? 1 << f[k].naxes : f[k].naxes + 1); v++) {
            long double at = 0;
            for (int i = 0; i < f[k].naxes; i++)
                if (cuboid ? v >> i & 1 : v == i + 1)
                    at += sign * dot(f->dim, s->normal, f[k].axes + i * f->dim);
            long double off = most - at, fuzz = 1e-12L * reach_of(f);
            cr_assert(s->faces[k] >> v & 1 ? off <= fuzz : off >= fuzz / 2, "%s: vertex %d of %d",
                      name, v, k);
        }
    }
}

static void judge_contact(judge *j, const fmb_frame *f, const said *s, bool touch, const char *name)
{
    if (f[0].speed || f[1].speed) {
        cr_assert_eq(s->npoints + s->faces[0] + s->faces[1], 0);
        return;
    }
    cr_assert_geq(s->npoints, 1, "%s", name);
    judge_faces(f, s, name);
    if (!j->acute)
        judge_points(j->solver, f, s, name);
    if (touch && j->even)
        judge_common(j->solver, f, s, name);
    j->touch += touch && j->even;
}

/* ---- families -------------------------------------------------------------------------------- */

static void judge_pair(judge *j, const fmb_frame *f, const char *name)
{
    fmb_proximity *p = NULL;
    fmb_result res = {.size = sizeof res};
    cr_assert_eq(fmb_depth(j->solver, f, FMB_NORM_EUCLIDEAN, &p, &res), FMB_OK);
    char measure[2] = "";
    double truth = fmb_proximity_length(p);
    bool touch = fmb_proximity_measure_text(p, measure, sizeof measure) == 1 && measure[0] == '0';
    fmb_proximity_free(p);
    j->meet += res.verdict == FMB_FEASIBLE;
    for (int i = 0; i < WAYS; i++) {
        said s = ask(j->way[i], f);
        if (i == IN_DOUBLES && s.verdict == FMB_UNKNOWN)
            continue;
        cr_assert_eq(s.verdict, res.verdict, "%s", name);
        if (s.verdict == FMB_FEASIBLE)
            judge_answer(f, &s, truth, name);
        else
            cr_assert(isnan(s.depth), "%s", name);
        if (i == TIGHTEST && s.verdict == FMB_FEASIBLE)
            judge_contact(j, f, &s, touch, name);
        j->sure += i == IN_DOUBLES && s.verdict == FMB_FEASIBLE;
        if (i != IN_DOUBLES && s.verdict == FMB_FEASIBLE)
            cr_assert(s.depth == truth || i != TIGHTEST, "%s: %a, not %a", name, s.depth, truth);
    }
}

/* Every third pair is made to touch along parallel edges, every fifth is brought near the middle.
 */
static void judge_family(judge *j, const study_pair_plan *plan, int pairs)
{
    const char *name = study_pair_family_text(plan->family);
    j->acute = plan->family == STUDY_PAIR_SPREAD || plan->family == STUDY_PAIR_RAGGED;
    j->even = plan->family == STUDY_PAIR_LATTICE || plan->family == STUDY_PAIR_TOUCHING ||
              plan->family == STUDY_PAIR_DEGENERATE || plan->family == STUDY_PAIR_INTEGER;
    for (int i = 0; i < pairs; i++) {
        study_pair pair;
        study_pair_draw(plan, 4, (uint64_t)i, &pair);
        int dim = plan->dim;
        if (i % 3 == 0 && pair.p.naxes > 1 && pair.q.naxes > 1)
            memcpy((double *)pair.q.axes + dim, pair.p.axes, (size_t)dim * sizeof(double));
        for (int c = 0; i % 5 < 3 && c < dim; c++)
            ((double *)pair.q.origin)[c] =
                pair.p.origin[c] + (pair.q.origin[c] - pair.p.origin[c]) / 8;
        judge_pair(j, (fmb_frame[2]){pair.p, pair.q}, name);
    }
}

static void judge_all(fmb_simd simd, int pairs)
{
    for (int dim = 2; dim <= 3; dim++) {
        judge j = judge_open(dim, simd);
        for (int i = 0; i < 4 * STUDY_PAIR_FAMILIES; i++) {
            study_pair_plan plan = {.family = (study_pair_family)(i / 4), .dim = dim};
            plan.moves = i % 4 == 1;
            plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
            if (i % 4 == 3)
                plan.naxes[i / 4 % 2] = 1 + i / 4 % dim;
            judge_family(&j, &plan, pairs);
        }
        cr_assert_gt(j.meet, 10 * pairs);
        cr_assert_gt(j.touch, pairs);
        judge_close(&j);
    }
}

Test(contact, never_further_off)
{
    judge_all(FMB_SIMD_PLAIN, 40);
    judge_all(FMB_SIMD_AUTO, 6);
}

/* Frames in no special place are told in doubles. */
Test(contact, decides)
{
    for (int dim = 2; dim <= 3; dim++) {
        judge j = judge_open(dim, FMB_SIMD_AUTO);
        study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE, .dim = dim};
        plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
        for (int i = 0; i < 200; i++) {
            study_pair pair;
            study_pair_draw(&plan, 5, (uint64_t)i, &pair);
            judge_pair(&j, (fmb_frame[2]){pair.p, pair.q}, "article");
        }
        cr_assert_geq(100 * j.sure, 98 * j.meet, "%d of %d", j.sure, j.meet);
        judge_close(&j);
    }
}

/* Boxes on each other, as they stand in a stack: parallel edges do not send them to integers. */
Test(contact, knows_stacks)
{
    const double axes[9] = {2, 0, 0, 0, 3, 0, 0, 0, 1}, low[3] = {0, 0, 0},
                 high[3] = {0.3, 0.1, 0.75};
    judge j = judge_open(3, FMB_SIMD_AUTO);
    const fmb_frame f[2] = {{FMB_CUBOID, 3, 3, low, axes, NULL},
                            {FMB_CUBOID, 3, 3, high, axes, NULL}};
    judge_pair(&j, f, "stack");
    cr_assert_eq(j.sure, 1);
    said s = ask(j.way[IN_DOUBLES], f);
    cr_assert(fabs(s.depth - 0.25) < 1e-12 && s.normal[2] > 0.999);
    judge_close(&j);
}

/* Frames that are points, and small ones, where products of their numbers underflow by and by. */
Test(contact, knows_small_frames)
{
    const double axes[9] = {2, 0, 0.5, 0, 3, 0, 0, 0.25, 1}, high[3] = {0.3, 0.1, 0.75};
    judge j = judge_open(3, FMB_SIMD_AUTO);
    for (int down = 60; down < 1100; down += down < 140 ? 2 : 37) {
        double small[9], low[3] = {0, 0, 0}, at[3];
        for (int i = 0; i < 9; i++)
            small[i] = ldexp(axes[i], -down);
        for (int i = 0; i < 3; i++)
            at[i] = ldexp(high[i], -down);
        for (int shape = 0; shape < 4; shape++)
            judge_pair(&j,
                       (fmb_frame[2]){{(fmb_shape)(shape & 1), 3, 3, low, small, NULL},
                                      {(fmb_shape)(shape / 2), 3, 3, at, small, NULL}},
                       "small");
    }
    cr_assert_gt(j.meet, 100);
    judge_close(&j);
}

/* All edges are parallel, or none is longer than 0: no normal tells anything. */
Test(contact, knows_segments)
{
    const double low[3] = {0, 0, 0};
    for (int dim = 2; dim <= 3; dim++) {
        judge j = judge_open(dim, FMB_SIMD_AUTO);
        for (int i = 0; i < 64; i++) {
            double axes[9], at[3];
            for (int c = 0; c < dim * dim; c++)
                axes[c] = i % 4 > 1 ? (c % dim + 1) * (c / dim + 1) : 0;
            for (int c = 0; c < dim; c++)
                at[c] = i / 4 % 4 * (c + 1) + i / 16 % 2;
            const fmb_shape shape = (fmb_shape)(i % 2);
            judge_pair(&j,
                       (fmb_frame[2]){{shape, dim, dim, low, axes, NULL},
                                      {FMB_CUBOID, dim, dim, at, axes, NULL}},
                       "segments");
        }
        cr_assert(j.meet > 4 && j.meet < 60);
        judge_close(&j);
    }
}

/* By number and by pointer the answers are the same. */
Test(contact, of_sets)
{
    enum { N = 500 };
    static study_pair pair[N];
    static fmb_frame p[N], q[N];
    fmb_frames *a = NULL, *b = NULL;
    fmb_frames_pair of[N];
    fmb_verdict verdict[2][N];
    double depth[2][N] = {{0}}, normal[2][3 * N] = {{0}};
    judge j = judge_open(3, FMB_SIMD_AUTO);
    study_pair_plan plan = {.dim = 3, .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
    for (uint32_t i = 0; i < N; i++) {
        study_pair_draw(&plan, 6, i, &pair[i]);
        p[i] = pair[i].p;
        q[i] = pair[i].q;
        of[i] = (fmb_frames_pair){i, i};
    }
    cr_assert_eq(fmb_frames_new(3, N, p, NULL, &a), FMB_OK);
    cr_assert_eq(fmb_frames_new(3, N, q, NULL, &b), FMB_OK);
    for (int way = TIGHTEST; way <= IN_DOUBLES; way++) {
        for (int i = 0; i < 2; i++) {
            fmb_pair_answers out = {.size = sizeof out, .verdict = verdict[i]};
            out.depth = depth[i];
            out.normal = normal[i];
            cr_assert_eq(i == 0 ? fmb_pair_test(j.way[way], N, p, q, &out)
                                : fmb_frames_test(j.way[way], a, b, N, of, &out),
                         FMB_OK);
        }
        cr_assert_arr_eq(verdict[0], verdict[1], sizeof verdict[0]);
        cr_assert_arr_eq(depth[0], depth[1], sizeof depth[0]);
        cr_assert_arr_eq(normal[0], normal[1], sizeof normal[0]);
    }
    fmb_frames_free(a);
    fmb_frames_free(b);
    judge_close(&j);
}

/* Other dimensions are refused, and hulls of more than 64 corners. */
Test(contact, refuses)
{
    const double x[4] = {0, 0, 0, 0}, axes[128] = {1, 0, 0, 1, 1, 1, 2, 2};
    double depth = 7;
    fmb_verdict verdict;
    for (int dim = 1; dim <= 4; dim++) {
        fmb_pair *k = NULL;
        fmb_frame f = {FMB_SIMPLEX_BY_CORNERS, dim, dim == 2 ? 64 : 0, x, axes, NULL};
        fmb_pair_answers out = {.size = sizeof out, .verdict = &verdict};
        out.depth = &depth;
        cr_assert_eq(fmb_pair_new(dim, NULL, NULL, &k), FMB_OK);
        cr_assert_eq(fmb_pair_test(k, 1, &f, &f, &out), dim == 3 ? FMB_OK : FMB_ERR_ARG);
        cr_assert_eq(depth, dim < 3 ? 7 : 0);
        cr_assert_eq(strlen(fmb_pair_trouble(k)) > 0, dim != 3);
        fmb_pair_free(k);
    }
}
