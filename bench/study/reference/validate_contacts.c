/* validate_contacts.c: see validate_contacts.h.
 *
 * The truth is that of <fmb/proximity.h>. What a pair is told may be off by 1e-12 of its reach
 * (<fmb/pair.h>), and by what is rounded here; numbers are long doubles, whose range is far beyond
 * that of doubles. Points are held against their frames exactly, rows too.
 */
#include "study/reference/validate_contacts.h"

#include <float.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include <fmb/frames.h>
#include <fmb/proximity.h>

#define FUZZ (1e-12L + 64 * LDBL_EPSILON)

struct study_contact_bench {
    int dim;
    atomic_bool stopped;
    fmb_pair *way;
    fmb_solver *solver;
    fmb_verdict verdict[STUDY_VALIDATE_MOST];
    double depth[STUDY_VALIDATE_MOST], distance[STUDY_VALIDATE_MOST], offset[STUDY_VALIDATE_MOST];
    double normal[3 * STUDY_VALIDATE_MOST], nearest[6 * STUDY_VALIDATE_MOST];
};

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status study_contact_bench_open(int dim, fmb_simd simd, study_contact_bench **out)
{
    study_contact_bench *b = calloc(1, sizeof *b);
    if (!b)
        return FMB_ERR_MEMORY;
    fmb_pair_options o = {.size = sizeof o, .simd = simd};
    b->dim = dim;
    fmb_status st = fmb_pair_new(dim, &o, NULL, &b->way);
    if (st == FMB_OK)
        st = fmb_solver_new(NULL, NULL, &b->solver);
    if (st == FMB_OK)
        *out = b;
    else
        study_contact_bench_close(b);
    return st;
}

void study_contact_bench_close(study_contact_bench *b)
{
    if (!b)
        return;
    fmb_pair_free(b->way);
    fmb_solver_free(b->solver);
    free(b);
}

void study_contact_bench_cancel(study_contact_bench *b)
{
    atomic_store(&b->stopped, true);
    fmb_pair_cancel(b->way);
    fmb_solver_cancel(b->solver);
}

/* ---- measures -------------------------------------------------------------------------------- */

static long double largest(int dim, const double *x)
{
    long double most = 0;
    for (int j = 0; x && j < dim; j++)
        most = fmaxl(most, fabsl((long double)x[j]));
    return most;
}

static long double along(int dim, const double *n, const double *x)
{
    long double sum = 0;
    for (int j = 0; x && j < dim; j++)
        sum += (long double)n[j] * x[j];
    return sum;
}

/* Coordinate j of edge i. */
static long double edge_of(const fmb_frame *f, int i, int j)
{
    bool corners = f->shape == FMB_CUBOID_BY_CORNERS || f->shape == FMB_SIMPLEX_BY_CORNERS;
    return (long double)f->axes[i * f->dim + j] - (corners ? f->origin[j] : 0);
}

static long double reach_of(const fmb_frame *f)
{
    long double sum = 0, shift = 0;
    for (int j = 0; j < f[0].dim; j++)
        shift = fmaxl(shift, fabsl((long double)f[1].origin[j] - f[0].origin[j]));
    for (int k = 0; k < 2; k++) {
        long double longest = 0, all = 0;
        for (int i = 0; i < f[k].naxes; i++) {
            long double size = 0;
            for (int j = 0; j < f->dim; j++)
                size = fmaxl(size, fabsl(edge_of(&f[k], i, j)));
            longest = fmaxl(longest, size);
            all += size;
        }
        sum += largest(f[k].dim, f[k].speed) + (f[k].naxes > f->dim ? 2 * longest : all);
    }
    return sum + shift;
}

/* The largest value (sign 1) of n x over the edges of f, or minus the least (-1). */
static long double farthest(const fmb_frame *f, const double *n, int sign)
{
    long double sum = 0, most = 0;
    for (int i = 0; i < f->naxes; i++) {
        long double at = 0;
        for (int j = 0; j < f->dim; j++)
            at += sign * n[j] * edge_of(f, i, j);
        sum += fmaxl(at, 0);
        most = fmaxl(most, at);
    }
    return f->shape == FMB_SIMPLEX || f->shape == FMB_SIMPLEX_BY_CORNERS ? most : sum;
}

/* How far the second must go along n so that no point of it is behind one of the first. */
static long double depth_along(const fmb_frame *f, const double *n)
{
    long double away = 0;
    for (int j = 0; j < f->dim; j++)
        away += n[j] * ((long double)f[0].origin[j] - f[1].origin[j]);
    long double drift = along(f->dim, n, f[0].speed) - along(f->dim, n, f[1].speed);
    return away + farthest(&f[0], n, 1) + farthest(&f[1], n, -1) + fmaxl(drift, 0);
}

static bool is_unit(int dim, const double *n)
{
    return fabsl(along(dim, n, n) - 1) < 8 * DBL_EPSILON;
}

/* ---- judging --------------------------------------------------------------------------------- */

/* What points may be off by: that, and what is rounded in the world. */
static long double point_fuzz(const fmb_frame *f)
{
    long double far = 0;
    for (int k = 0; k < 2; k++)
        far = fmaxl(far, largest(f[k].dim, f[k].origin));
    return FUZZ * reach_of(f) + 16 * DBL_EPSILON * far + 16 * DBL_TRUE_MIN;
}

static fmb_status is_point_in_frame(const study_contact_bench *b, const fmb_frame *f,
                                    const double *x, long double fuzz, bool *good)
{
    fmb_proximity *p = NULL;
    fmb_result res = {.size = sizeof res};
    const fmb_frame two[2] = {*f, {FMB_CUBOID, f->dim, 0, x, NULL, NULL}};
    for (int j = 0; j < f->dim; j++)
        *good &= isfinite(x[j]);
    fmb_status st = *good ? fmb_distance(b->solver, two, FMB_NORM_EUCLIDEAN, &p, &res) : FMB_OK;
    *good &= fmb_proximity_length(p) <= fuzz;
    fmb_proximity_free(p);
    return st;
}

/* The row of pair i, if it has one. */
static fmb_status is_row_between(const study_contact_bench *b, const fmb_frame *f, size_t i,
                                 bool *good)
{
    fmb_system *row = NULL;
    if (isnan(b->offset[i]))
        return FMB_OK;
    fmb_status st = fmb_system_new(b->dim, NULL, &row);
    if (st == FMB_OK)
        st = fmb_system_add(row, b->normal + (size_t)b->dim * i, FMB_LE, b->offset[i]);
    *good &= st == FMB_OK && fmb_separates(f, FMB_CONTACT_CLOSED, row);
    fmb_system_free(row);
    return st;
}

static fmb_status judge_apart(const study_contact_bench *b, const fmb_frame *f, size_t i,
                              long double truth, bool *good)
{
    size_t dim = (size_t)b->dim;
    const double *n = b->normal + dim * i, *x = b->nearest + 2 * dim * i;
    long double off = FUZZ * reach_of(f) + DBL_TRUE_MIN, between = 0;
    for (size_t j = 0; j < dim; j++)
        between = hypotl(between, (long double)x[j] - x[dim + j]);
    *good &= fabsl(b->distance[i] - truth) <= off && is_unit(b->dim, n);
    *good &= -depth_along(f, n) >= truth - off;
    *good &= fabsl(between - truth) <= 4 * point_fuzz(f);
    fmb_status st = is_row_between(b, f, i, good);
    for (size_t k = 0; k < 2 && st == FMB_OK && *good && !f[0].speed && !f[1].speed; k++)
        st = is_point_in_frame(b, &f[k], x + dim * k, 4 * point_fuzz(f), good);
    return st;
}

static void judge_meeting(const study_contact_bench *b, const fmb_frame *f, size_t i,
                          long double truth, bool *good)
{
    const double *n = b->normal + (size_t)b->dim * i;
    long double off = FUZZ * reach_of(f) + DBL_TRUE_MIN;
    *good &= b->distance[i] == 0 && fabsl(b->depth[i] - truth) <= off && is_unit(b->dim, n);
    *good &= depth_along(f, n) <= truth + off;
}

static fmb_status judge(const study_contact_bench *b, const fmb_frame *f, size_t i, bool *good)
{
    fmb_proximity *p = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_verdict said = b->verdict[i];
    fmb_status st = (said == FMB_FEASIBLE ? fmb_depth : fmb_distance)(b->solver, f,
                                                                      FMB_NORM_EUCLIDEAN, &p, &res);
    *good = st == FMB_OK && said == res.verdict && p;
    if (*good && said == FMB_FEASIBLE)
        judge_meeting(b, f, i, fmb_proximity_length(p), good);
    else if (*good)
        st = judge_apart(b, f, i, fmb_proximity_length(p), good);
    fmb_proximity_free(p);
    return st;
}

/* ---- questions ------------------------------------------------------------------------------- */

static fmb_status ask(study_contact_bench *b, size_t n, const fmb_frame *p, const fmb_frame *q,
                      bool by_sets)
{
    fmb_pair_answers out = {.size = sizeof out, .verdict = b->verdict, .depth = b->depth};
    fmb_frames_pair pair[STUDY_VALIDATE_MOST];
    fmb_frames *of[2] = {NULL, NULL};
    out.normal = b->normal;
    out.distance = b->distance;
    out.nearest = b->nearest;
    out.offset = b->offset;
    if (!by_sets)
        return fmb_pair_test(b->way, n, p, q, &out);
    for (uint32_t i = 0; i < n; i++)
        pair[i] = (fmb_frames_pair){i, i};
    fmb_status st = fmb_frames_new(b->dim, n, p, NULL, &of[0]);
    if (st == FMB_OK)
        st = fmb_frames_new(b->dim, n, q, NULL, &of[1]);
    if (st == FMB_OK)
        st = fmb_frames_test(b->way, of[0], of[1], n, pair, &out);
    fmb_frames_free(of[0]);
    fmb_frames_free(of[1]);
    return st;
}

fmb_status study_contact_bench_run(study_contact_bench *b, size_t n, const fmb_frame *p,
                                   const fmb_frame *q, const size_t *index, unsigned *faults,
                                   study_tally *tally)
{
    fmb_pair_counts before = {.size = sizeof before}, after = {.size = sizeof after};
    fmb_status st = fmb_pair_count(b->way, &before);
    for (int order = 0; order < 2; order++) {
        const fmb_frame *x = order ? q : p, *y = order ? p : q;
        if (st == FMB_OK && !atomic_load(&b->stopped))
            st = ask(b, n, x, y, order);
        for (size_t i = 0; st == FMB_OK && i < n && !atomic_load(&b->stopped); i++) {
            bool good = true;
            st = judge(b, (const fmb_frame[2]){x[i], y[i]}, i, &good);
            faults[index[i]] |= good ? 0 : STUDY_FAULT_NEAR;
        }
    }
    tally->contacts += n;
    if (st == FMB_OK)
        st = fmb_pair_count(b->way, &after);
    tally->contacts_open += after.exact_boxes - before.exact_boxes;
    return st;
}
