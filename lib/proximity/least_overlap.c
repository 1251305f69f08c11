/* least_overlap.c: see least_overlap.h.
 *
 * Theorem. If M has an interior, its depth is the least overlap / size over the normals of all
 * choices of D - 1 independent directions, from the drift and edges of P and Q: all of a cuboid,
 * those of a simplex at one corner. Proof. The depth is the overlap / size of a facet, and no
 * normal has less. A facet is a face of P less a face of Q, with the drift or without; the drift
 * and the edges of both faces span it: all edges of a cuboid's face, those of a simplex's at one
 * corner.
 *
 * The coordinates of a normal are the minors of its D - 1 directions. They are computed direction
 * by direction, so that choices with a common beginning share minors, and only where doubles do not
 * prove that the overlap is more than the least known (rough_overlap.c).
 */
#include "proximity/least_overlap.h"

#include <math.h>
#include <string.h>

#include "num/vec.h"
#include "proximity/normal_search.h"

/* ---- life ------------------------------------------------------------------------------------ */

void fmb_least_overlap_init(fmb_least_overlap *x)
{
    x->found = false;
    mpz_inits(x->overlap, x->size, NULL);
    for (int j = 0; j < FMB_NORMALS_MOST_DIM; j++)
        mpz_init(x->normal[j]);
}

void fmb_least_overlap_clear(fmb_least_overlap *x)
{
    mpz_clears(x->overlap, x->size, NULL);
    for (int j = 0; j < FMB_NORMALS_MOST_DIM; j++)
        mpz_clear(x->normal[j]);
}

static fmb_normal_direction *add_direction(fmb_normal_search *x, int side, int group, int end)
{
    fmb_normal_direction *d = &x->direction[x->directions];
    *d = (fmb_normal_direction){
        .side = side, .group = group, .end = end, .exact = x->cell + x->directions * x->m->dim};
    x->directions++;
    return d;
}

/* Add the edges from corner `group` to later ones; for corner 0, the origin, these are the axes. */
static void add_edges(fmb_normal_search *x, int side, int group)
{
    const fmb_minkowski_frame *f = &x->m->frame[side];
    for (int i = group + 1; i <= f->naxes; i++) {
        fmb_normal_direction *d = add_direction(x, side, group, i);
        for (int j = 0; j < x->m->dim; j++) {
            mpz_set(d->exact[j], f->row[i * x->m->dim + j]);
            if (group > 0)
                mpz_sub(d->exact[j], d->exact[j], f->row[group * x->m->dim + j]);
            if (side == 1)
                mpz_neg(d->exact[j], d->exact[j]);
        }
    }
}

static void add_directions(fmb_normal_search *x)
{
    for (int side = 0; side < 2; side++) {
        const fmb_minkowski_frame *f = &x->m->frame[side];
        x->of[side] = (fmb_normal_summand){f->naxes, x->directions, f->shape == FMB_SIMPLEX};
        for (int group = 0; group == 0 || (x->of[side].simplex && group < f->naxes); group++)
            add_edges(x, side, group);
    }
    x->of[2] = (fmb_normal_summand){x->m->moves, x->directions, false};
    fmb_normal_direction *drift = x->m->moves ? add_direction(x, 2, 0, 1) : NULL;
    int ours = x->directions;
    for (int j = 0; j < x->m->dim; j++) {
        if (drift)
            mpz_set(drift->exact[j], x->m->drift[j]);
        mpz_set_ui(add_direction(x, 3, 0, 1)->exact[j], 1);
        mpz_sub(x->away[j], x->m->frame[0].row[j], x->m->frame[1].row[j]);
    }
    x->directions = ours;
}

static fmb_status open_search(fmb_normal_search *x)
{
    size_t dim = (size_t)x->m->dim, edges = 2 + dim; /* away, the drift, the world */
    for (int side = 0; side < 2; side++)
        edges += (size_t)x->m->frame[side].naxes * ((size_t)x->m->frame[side].naxes + 1) / 2;
    x->cells = edges * dim + ((size_t)1 << dim);
    fmb_least_overlap_init(&x->at);
    mpz_inits(x->low, x->high, x->span[0], x->span[1], x->t, x->s, NULL);
    x->cell = fmb_vec_block(x->cells, x->mem);
    if (!x->cell)
        return fmb_mem_status(x->mem);
    x->exact = x->cell + edges * dim;
    x->away = x->exact - dim;
    x->best = (fmb_normal_bounds){INFINITY, INFINITY};
    fmb_minkowski_shorten(x->m, x->unit);
    add_directions(x);
    fmb_normal_search_scale(x);
    mpz_set_ui(x->exact[0], 1);
    return FMB_OK;
}

static void close_search(fmb_normal_search *x)
{
    fmb_least_overlap_clear(&x->at);
    fmb_vec_block_free(x->cell, x->cells, x->mem);
    mpz_clears(x->low, x->high, x->span[0], x->span[1], x->t, x->s, NULL);
}

/* ---- minors ---------------------------------------------------------------------------------- */

/* The next larger set of as many rows. */
static unsigned next_set(unsigned set)
{
    unsigned low = set & -set, carry = set + low;
    return carry | (set ^ carry) >> (2 + __builtin_ctz(low));
}

/* All minors with one more direction, by Laplace expansion along it; either all have the right
 * sign, or all the wrong one. Are they all 0? */
static bool find_exact_minors(fmb_normal_search *x, int level)
{
    bool zero = true;
    mpz_t *d = x->direction[x->chosen[level]].exact;
    for (unsigned set = (2U << level) - 1; set < 1U << x->m->dim; set = next_set(set)) {
        mpz_ptr sum = x->exact[set];
        bool minus = false;
        mpz_set_ui(sum, 0);
        for (unsigned rest = set; rest != 0; rest &= rest - 1, minus = !minus) {
            unsigned row = (unsigned)__builtin_ctz(rest), less = set & ~(1U << row);
            (minus ? mpz_submul : mpz_addmul)(sum, d[row], x->exact[less]);
        }
        zero &= mpz_sgn(sum) == 0;
    }
    x->known = level + 1;
    return zero;
}

/* Is the last chosen direction dependent on the earlier ones? *told: doubles decided all so far. */
static bool is_dependent(fmb_normal_search *x, int level, bool *told)
{
    bool zero = false;
    x->known = x->known < level ? x->known : level;
    *told = *told && fmb_normal_is_independent(x, level);
    while (!*told && x->known <= level)
        zero = find_exact_minors(x, x->known);
    return zero;
}

/* ---- overlaps in whole numbers --------------------------------------------------------------- */

/* The extent of M along the normal of the present choice. The overlap is the shorter way from 0 out
 * of M, and the normal is oriented that way. */
static void measure_overlap(fmb_normal_search *x)
{
    fmb_least_overlap *n = &x->at;
    int all = (1 << x->m->dim) - 1;
    for (int j = 0; j < x->m->dim; j++)
        (j & 1 ? mpz_neg : mpz_set)(n->normal[j], x->exact[all & ~(1 << j)]);
    fmb_minkowski_dot(x->m, n->normal, x->away, x->low);
    mpz_set(x->high, x->low);
    for (const fmb_normal_summand *f = x->of; f < x->of + 3; f++) {
        mpz_set_ui(x->span[0], 0);
        mpz_set_ui(x->span[1], 0);
        for (int i = 0; i < f->axes; i++) {
            const fmb_normal_direction *d = &x->direction[f->first + i];
            fmb_minkowski_dot(x->m, n->normal, d->exact, x->t);
            mpz_mul_2exp(x->t, x->t, d->power);
            mpz_ptr most = x->span[mpz_sgn(x->t) > 0];
            if (!f->simplex)
                mpz_add(most, most, x->t);
            else if (mpz_cmpabs(x->t, most) > 0)
                mpz_set(most, x->t);
        }
        mpz_add(x->low, x->low, x->span[0]);
        mpz_add(x->high, x->high, x->span[1]);
    }
    mpz_neg(x->low, x->low);
    bool back = mpz_cmp(x->low, x->high) < 0;
    mpz_mul_2exp(n->overlap, back ? x->low : x->high, x->coarsest);
    for (int j = 0; back && j < x->m->dim; j++)
        mpz_neg(n->normal[j], n->normal[j]);
}

/* Convert the present normal to the units of the space, and compute its size. */
static void measure_normal(fmb_normal_search *x)
{
    fmb_least_overlap *n = &x->at;
    for (int j = 0; j < x->m->dim; j++)
        mpz_mul_2exp(n->normal[j], n->normal[j], x->coarsest - x->unit[j]);
    if (x->norm == FMB_NORM_EUCLIDEAN) {
        fmb_minkowski_dot(x->m, n->normal, n->normal, n->size);
        return;
    }
    mpz_set_ui(n->size, 0);
    for (int j = 0; j < x->m->dim; j++) {
        mpz_abs(x->t, n->normal[j]);
        mpz_add(n->size, n->size, x->t);
    }
}

/* Is the present overlap / size less than the least? A negative overlap decides; else both are at
 * least 0. */
static bool is_less(fmb_normal_search *x, const fmb_least_overlap *least)
{
    if (!least->found || mpz_sgn(x->at.overlap) < 0)
        return true;
    mpz_set(x->t, x->at.overlap);
    mpz_set(x->s, least->overlap);
    if (x->norm == FMB_NORM_EUCLIDEAN) {
        mpz_mul(x->t, x->t, x->t);
        mpz_mul(x->s, x->s, x->s);
    }
    mpz_mul(x->t, x->t, least->size);
    mpz_mul(x->s, x->s, x->at.size);
    return mpz_cmp(x->t, x->s) < 0;
}

static void swap_overlaps(fmb_least_overlap *a, fmb_least_overlap *b)
{
    fmb_least_overlap t = *a;
    *a = *b;
    *b = t;
}

/* ---- all normals ----------------------------------------------------------------------------- */

/* Compute the normal of the present choice in integers, and compare it with the least one. */
static fmb_status measure(fmb_normal_search *x, fmb_least_overlap *out)
{
    while (x->known < x->m->dim - 1)
        find_exact_minors(x, x->known);
    measure_overlap(x);
    measure_normal(x);
    x->at.found = true;
    if (is_less(x, out)) {
        swap_overlaps(&x->at, out);
        fmb_normal_search_take(x, out);
    }
    return fmb_run_poll(x->run);
}

/* Likewise for the waiting choice, if there is one. */
static fmb_status measure_waiting(fmb_normal_search *x, fmb_least_overlap *out)
{
    int chosen[FMB_NORMALS_MOST_DIM];
    if (!x->waits)
        return FMB_OK;
    memcpy(chosen, x->chosen, sizeof chosen);
    memcpy(x->chosen, x->waiting, sizeof chosen);
    x->known = 0;
    x->waits = false;
    fmb_status st = measure(x, out);
    memcpy(x->chosen, chosen, sizeof chosen);
    x->known = 0;
    return st;
}

/* Test the normal of dim - 1 independent directions; told: doubles proved their independence. A
 * normal with surely less overlap than the least waits until one is met that is neither surely less
 * nor surely more: so those that are the least only for a while are not computed in integers. */
static fmb_status look_at_normal(fmb_normal_search *x, bool told, fmb_least_overlap *out)
{
    if (told && fmb_normal_is_surely_more(x))
        return FMB_OK;
    fmb_normal_bounds bounds = told ? fmb_normal_bound(x) : (fmb_normal_bounds){0, INFINITY};
    if (bounds.low > 0 && bounds.high < x->best.low) {
        x->best = bounds;
        x->waits = true;
        memcpy(x->waiting, x->chosen, sizeof x->waiting);
        return FMB_OK;
    }
    FMB_TRY(measure_waiting(x, out));
    return measure(x, out);
}

/* Is 0 known not to be inside M? Then no other normal is needed. */
static bool is_on_boundary(const fmb_least_overlap *x)
{
    return x->found && mpz_sgn(x->overlap) <= 0;
}

/* At most so many directions can be chosen after d. */
static int directions_after(const fmb_normal_search *x, const fmb_normal_direction *d)
{
    int n = x->of[d->side].axes - d->end;
    for (int side = d->side + 1; side < 3; side++)
        n += x->of[side].axes;
    return n;
}

/* All choices that begin with the first `level` ones; told: doubles proved these independent. */
static fmb_status choose(fmb_normal_search *x, int level, int from, bool told,
                         fmb_least_overlap *out)
{
    fmb_status st = fmb_run_poll(x->run);
    if (level == x->m->dim - 1)
        return st == FMB_OK ? look_at_normal(x, told, out) : st;
    const fmb_normal_direction *last = level > 0 ? &x->direction[x->chosen[level - 1]] : NULL;
    for (int i = from; st == FMB_OK && i < x->directions && !is_on_boundary(out); i++) {
        const fmb_normal_direction *next = &x->direction[i];
        bool still = told;
        if (last && last->side == next->side && last->group != next->group)
            continue;
        if (directions_after(x, next) < x->m->dim - 2 - level)
            continue;
        x->chosen[level] = i;
        if (!is_dependent(x, level, &still))
            st = choose(x, level + 1, i + 1, still, out);
    }
    return st;
}

/* A normal perpendicular to all directions, of which fewer than dim - 1 are independent: axes of
 * the world complete them. */
static void take_any_normal(fmb_normal_search *x, fmb_least_overlap *out)
{
    int level = 0;
    x->known = 0;
    for (int i = 0; level < x->m->dim - 1; i++) {
        x->chosen[level] = i;
        level += !find_exact_minors(x, level);
    }
    measure_overlap(x);
    measure_normal(x);
    swap_overlaps(&x->at, out);
    out->found = false;
}

bool fmb_has_normals(const fmb_minkowski *m)
{
    return m->dim <= FMB_NORMALS_MOST_DIM && m->frame[0].naxes <= m->dim &&
           m->frame[1].naxes <= m->dim;
}

fmb_status fmb_find_least_overlap(fmb_minkowski *m, fmb_norm norm, fmb_run *run,
                                  fmb_least_overlap *out)
{
    fmb_normal_search x = {.m = m, .norm = norm, .run = run, .mem = m->mem};
    fmb_status st = open_search(&x);
    FMB_THEN(st, choose(&x, 0, 0, true, out));
    if (st == FMB_OK && !is_on_boundary(out))
        st = measure_waiting(&x, out);
    if (st == FMB_OK && !out->found)
        take_any_normal(&x, out);
    close_search(&x);
    return st;
}
