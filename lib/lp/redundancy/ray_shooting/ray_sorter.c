/* ray_sorter.c: see ray_sorter.h.
 *
 * Seen from the interior point (polar_points.h), a row is irredundant if its point is a vertex of
 * the hull of all points and 0, and redundant if it is in the hull of others. So each row is tested
 * for membership in the hull of the known vertices. If it is inside, the vertices around it are
 * solved for exactly: a proof. If not, some direction separates it from them, and the point
 * farthest in that direction is a new vertex: a ray proves it. So no test uses more points than
 * there are vertices. Source: Clarkson 1994, More output-sensitive geometric algorithms.
 */
#include "lp/redundancy/ray_shooting/ray_sorter.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"
#include "num/gcd.h"
#include "num/rationals.h"

/* Smaller multipliers count as 0, and are used as they are if that fails. */
#define NEARLY_NONE 1e-9
/* Testing this many vertices takes as long as shooting a ray, apart from the ray's own blocks. */
#define MANY_KNOWN 1024
/* With more vertices than this, a test uses those near the row. */
#define MOST_ACTIVE(d) (64 + 5 * (d))

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_ray_sorter_init(fmb_ray_sorter *s, fmb_run *run, const fmb_polar_points *points,
                               fmb_fate *fate, const fmb_verdicts *told)
{
    fmb_mem *mem = run->mem;
    size_t d = points->d;
    *s = (fmb_ray_sorter){.run = run, .points = points, .fate = fate, .told = told};
    FMB_TRY(FMB_ARRAYS(mem, true, FMB_ARRAY_ZERO(s->is_active, points->m), FMB_ARRAY(s->target, d),
                       FMB_ARRAY(s->support, d)));
    FMB_TRY(fmb_membership_init(&s->membership, run, d));
    FMB_TRY(fmb_ray_init(&s->ray, run, points));
    FMB_TRY(fmb_combination_init(&s->combination, mem, points->n, points->row));
    return fmb_rationals_new(&s->x, points->n, mem);
}

static fmb_status hold_known_rows(fmb_ray_sorter *s, bool get)
{
    return FMB_ARRAYS(s->run->mem, get, FMB_ARRAY(s->name, s->capacity),
                      FMB_ARRAY(s->at, s->points->d * s->capacity),
                      FMB_ARRAY(s->score, s->capacity));
}

void fmb_ray_sorter_clear(fmb_ray_sorter *s)
{
    if (!s->run)
        return;
    fmb_mem *mem = s->run->mem;
    size_t d = s->points->d;
    (void)hold_known_rows(s, false);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(s->is_active, s->points->m), FMB_ARRAY(s->target, d),
                   FMB_ARRAY(s->support, d));
    fmb_rationals_free(s->x, s->points->n, mem);
    fmb_membership_clear(&s->membership);
    fmb_ray_clear(&s->ray);
    fmb_combination_clear(&s->combination);
    s->run = NULL;
}

/* ---- vertices known -------------------------------------------------------------------------- */

static fmb_status reserve_known_rows(fmb_ray_sorter *s, size_t capacity)
{
    size_t d = s->points->d;
    fmb_ray_sorter old = *s;
    s->capacity = capacity;
    fmb_status st = hold_known_rows(s, true);
    if (st != FMB_OK) {
        (void)hold_known_rows(s, false);
        *s = old;
        return st;
    }
    if (s->known > 0)
        memcpy(s->name, old.name, s->known * sizeof *s->name);
    for (size_t k = 0; s->known > 0 && k < d; k++)
        memcpy(&s->at[k * capacity], &old.at[k * old.capacity], s->known * sizeof *s->at);
    (void)hold_known_rows(&old, false);
    return FMB_OK;
}

static void aim_at_point(fmb_ray_sorter *s, size_t i)
{
    fmb_polar_points_round_point(s->points, i, s->target);
}

static void mark_rows_of_membership(fmb_ray_sorter *s, bool active)
{
    for (size_t j = 0; j < fmb_membership_size(&s->membership); j++)
        s->is_active[s->membership.name[j]] = active;
}

/* Add row i to the membership program; if that is full, points outside of its basis are removed.
 */
static fmb_status activate_row(fmb_ray_sorter *s, size_t i)
{
    double point[256], *q = point;
    size_t d = s->points->d;
    if (s->is_active[i])
        return FMB_OK;
    if (d > sizeof point / sizeof *point)
        FMB_TRY(FMB_GET(s->run->mem, q, d));
    fmb_status st = FMB_OK;
    if (fmb_membership_size(&s->membership) >= MOST_ACTIVE(d)) {
        mark_rows_of_membership(s, false);
        st = fmb_membership_forget(&s->membership);
        mark_rows_of_membership(s, true);
    }
    fmb_polar_points_round_point(s->points, i, q);
    s->is_active[i] = true;
    FMB_THEN(st, fmb_membership_add(&s->membership, q, i));
    if (q != point)
        fmb_mem_put(s->run->mem, q, d, sizeof *q);
    return st;
}

/* Keep row i, which the last ray met alone. */
static fmb_status keep_row(fmb_ray_sorter *s, size_t i)
{
    s->fate[i] = FMB_FATE_KEPT;
    if (s->told && s->told->irredundant) {
        FMB_TRY(fmb_ray_beyond(&s->ray, s->x));
        FMB_TRY(s->told->irredundant(s->told->self, i, s->x));
    }
    if (s->known == s->capacity)
        FMB_TRY(reserve_known_rows(s, s->capacity == 0 ? 64 : 2 * s->capacity));
    for (size_t k = 0; k < s->points->d; k++)
        s->at[k * s->capacity + s->known] =
            s->points->round[k * s->points->m + s->points->place[i]];
    s->name[s->known++] = i;
    return activate_row(s, i);
}

/* ---- one row --------------------------------------------------------------------------------- */

/* score = the product of the target with each known vertex; returns the largest. */
static double score_known_rows(fmb_ray_sorter *s)
{
    double most[4] = {0};
    size_t j = 0;
    if (s->known == 0)
        return 0;
    memset(s->score, 0, s->known * sizeof *s->score);
    for (size_t k = 0; k < s->points->d; k++)
        s->run->kernels->accumulate(s->score, &s->at[k * s->capacity], s->known, s->target[k]);
    for (; j + 4 <= s->known; j += 4)
        for (size_t k = 0; k < 4; k++)
            most[k] = s->score[j + k] > most[k] ? s->score[j + k] : most[k];
    for (; j < s->known; j++)
        most[0] = s->score[j] > most[0] ? s->score[j] : most[0];
    return fmax(fmax(most[0], most[1]), fmax(most[2], most[3]));
}

/* Is the target farther in its own direction than all known vertices? If these are many, a ray is
 * faster. */
static bool does_target_stick_out(fmb_ray_sorter *s)
{
    double square = 0;
    if (s->known > MANY_KNOWN + 2 * s->points->blocks)
        return true;
    for (size_t k = 0; k < s->points->d; k++)
        square += s->target[k] * s->target[k];
    return square > 0 && square > (1 + NEARLY_NONE) * score_known_rows(s);
}

static fmb_status tell_of_combination(fmb_ray_sorter *s, size_t i)
{
    const fmb_combination *c = &s->combination;
    const fmb_poll poll = fmb_run_asked(s->run);
    fmb_status st = FMB_OK;
    fmb_weights w = {0};
    mpq_t factor;
    if (!s->told || !s->told->redundant)
        return FMB_OK;
    mpq_init(factor);
    for (size_t k = 0; st == FMB_OK && k < c->size; k++) {
        mpq_set_z(factor, c->part[k]);
        st = fmb_long_divide(factor, c->all, &poll);
        FMB_THEN(st, fmb_weights_add(&w, (uint32_t)c->index[k], factor, s->run->mem));
    }
    FMB_THEN(st, s->told->redundant(s->told->self, i, &w));
    fmb_weights_clear(&w, s->run->mem);
    mpq_clear(factor);
    return st;
}

/* Prove row i by the points of the basis with larger values than this. */
static fmb_status prove_by_basis(fmb_ray_sorter *s, size_t i, double least)
{
    size_t size = 0;
    bool found;
    for (size_t r = 0; r < s->points->d; r++) {
        size_t j = fmb_membership_name(&s->membership, r);
        if (j != SIZE_MAX && fmb_membership_value(&s->membership, r) > least)
            s->support[size++] = j;
    }
    FMB_TRY(fmb_combine(&s->combination, s->run, i, s->support, size, &found));
    if (!found || !fmb_combination_proves(&s->combination))
        return FMB_OK;
    s->fate[i] = FMB_FATE_REDUNDANT;
    return tell_of_combination(s, i);
}

static fmb_status prove_implied(fmb_ray_sorter *s, size_t i)
{
    FMB_TRY(prove_by_basis(s, i, NEARLY_NONE));
    return s->fate[i] == FMB_FATE_UNKNOWN ? prove_by_basis(s, i, -INFINITY) : FMB_OK;
}

/* The membership program finds row i implied. If that cannot be proved, values taken for 0 may have
 * been negative. */
static fmb_status prove_or_look_closer(fmb_ray_sorter *s, size_t i, fmb_side_of_hull *side)
{
    fmb_status st = prove_implied(s, i);
    if (st != FMB_OK || s->fate[i] != FMB_FATE_UNKNOWN)
        return st;
    st = fmb_membership_ask(&s->membership, s->target, true, side);
    return st == FMB_OK && *side == FMB_HULL_INSIDE ? prove_implied(s, i) : st;
}

/* Shoot a ray; *progress: it met a row that was unknown or not active so far. */
static fmb_status shoot_for_vertex(fmb_ray_sorter *s, const double *way, bool *progress)
{
    size_t hit = fmb_ray_shoot(&s->ray, way, true);
    if (hit == SIZE_MAX || s->is_active[hit])
        hit = fmb_ray_shoot(&s->ray, way, false);
    *progress = hit != SIZE_MAX && !s->is_active[hit];
    if (hit == SIZE_MAX)
        return FMB_OK;
    if (s->fate[hit] == FMB_FATE_UNKNOWN)
        return keep_row(s, hit);
    return activate_row(s, hit);
}

/* Query the membership program for row i, and act on its answer. */
static fmb_status ask_about_row(fmb_ray_sorter *s, size_t i, bool *progress)
{
    fmb_side_of_hull side;
    fmb_status st = fmb_membership_ask(&s->membership, s->target, false, &side);
    *progress = false;
    if (st == FMB_OK && side == FMB_HULL_INSIDE)
        st = prove_or_look_closer(s, i, &side);
    if (st != FMB_OK || side == FMB_HULL_NONE || s->fate[i] != FMB_FATE_UNKNOWN)
        return st;
    return shoot_for_vertex(s, s->membership.way, progress);
}

/* Most vertices are farther in their own directions than all known vertices. */
static fmb_status shoot_along_normals(fmb_ray_sorter *s, size_t from, size_t to)
{
    for (size_t at = from; at < to; at++) {
        size_t i = s->points->order[at];
        bool progress;
        aim_at_point(s, i);
        if (s->fate[i] == FMB_FATE_UNKNOWN && does_target_stick_out(s))
            FMB_TRY(shoot_for_vertex(s, s->target, &progress));
        FMB_TRY(fmb_run_poll(s->run));
    }
    return FMB_OK;
}

static fmb_status sort_one_row(fmb_ray_sorter *s, size_t i)
{
    bool progress = true;
    aim_at_point(s, i);
    while (progress && s->fate[i] == FMB_FATE_UNKNOWN)
        FMB_TRY(ask_about_row(s, i, &progress));
    return fmb_run_poll(s->run);
}

fmb_status fmb_ray_sorter_sort(fmb_ray_sorter *s, size_t from, size_t to)
{
    FMB_TRY(shoot_along_normals(s, from, to));
    for (size_t at = from; at < to; at++)
        if (s->fate[s->points->order[at]] == FMB_FATE_UNKNOWN)
            FMB_TRY(sort_one_row(s, s->points->order[at]));
    return FMB_OK;
}
