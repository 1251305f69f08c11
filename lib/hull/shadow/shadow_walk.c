/* shadow_walk.c: the shadow vertex method; see shadow.h.
 *
 * A feasible dictionary writes the two variables as constants plus sums over nonbasic slacks >= 0.
 * Each nonbasic slack j moves the shadow point in a direction R_j, and the shadow point is the
 * farthest in the direction w if no w.R_j is positive; then the numbers -w.R_j >= 0 are multipliers
 * that prove w.(x, y) <= w.(the point). Now turn w until some w.R_j is 0: an edge begins here,
 * along R_j, and w is its normal. Pivot along it until nothing moves the point further that way:
 * the next vertex of the shadow. At a degenerate vertex a pivot may move nothing; then no edge is
 * noted, and w turns on. So the work is one pivot or so for each edge, however many dimensions are
 * behind it. Sources: Gass and Saaty 1955 (parametric objective); Borgwardt 1987 (shadow vertices).
 */
#include "hull/shadow/shadow_walk_private.h"

static void init_walk_numbers(fmb_shadow_walk *w)
{
    mpz_inits(w->along[X], w->along[Y], w->from[X], w->from[Y], w->r[X], w->r[Y], w->best[X],
              w->best[Y], w->t, w->u, NULL);
    mpq_inits(w->start[X], w->start[Y], w->here[X], w->here[Y], w->q, NULL);
}

static void clear_walk_numbers(fmb_shadow_walk *w)
{
    mpz_clears(w->along[X], w->along[Y], w->from[X], w->from[Y], w->r[X], w->r[Y], w->best[X],
               w->best[Y], w->t, w->u, NULL);
    mpq_clears(w->start[X], w->start[Y], w->here[X], w->here[Y], w->q, NULL);
}

static bool is_shadow_at(fmb_shadow_walk *w, mpq_t *point)
{
    fmb_shadow_walk_locate(w, w->here);
    return mpq_equal(w->here[X], point[X]) && mpq_equal(w->here[Y], point[Y]);
}

/* ---- edges ----------------------------------------------------------------------------------- */

/* The multiplier -normal.R_j of every nonbasic slack. */
static fmb_status add_edge_multipliers(fmb_shadow_walk *w, fmb_edge *e)
{
    const fmb_lp *lp = w->lp;
    fmb_status st = FMB_OK;
    mpq_t sum;
    mpq_init(sum);
    for (size_t j = 0; st == FMB_OK && j < (size_t)lp->n; j++) {
        if (fmb_lp_is_x(lp, lp->column[j]))
            continue;
        mpq_set_ui(sum, 0, 1);
        for (int axis = X; axis <= Y; axis++) {
            fmb_vec_get(fmb_shadow_walk_row_of(w, axis), j, mpq_numref(w->q));
            fmb_vec_get(fmb_shadow_walk_row_of(w, axis), fmb_lp_place(lp, FMB_LP_OWN),
                        mpq_denref(w->q));
            mpz_mul(mpq_numref(w->q), mpq_numref(w->q), e->normal[axis]);
            mpq_canonicalize(w->q); /* the denominator is negative: so is the product */
            mpq_add(sum, sum, w->q);
        }
        if (mpq_sgn(sum) != 0)
            st = fmb_weights_add(&e->w, (uint32_t)(lp->column[j] - (size_t)lp->n), sum,
                                 lp->run->mem);
    }
    mpq_clear(sum);
    return st;
}

/* Note the edge along w->along, which the current vertex lies on. */
static fmb_status add_polygon_edge(fmb_shadow_walk *w)
{
    fmb_edge *e;
    fmb_status st = fmb_edges_add(w->edges, w->lp->run->mem, &e);
    if (st != FMB_OK)
        return st;
    mpz_gcd(w->t, w->along[X], w->along[Y]);
    mpz_divexact(e->normal[X], w->along[Y], w->t);
    mpz_divexact(e->normal[Y], w->along[X], w->t);
    mpz_neg(e->normal[w->turn > 0 ? Y : X], e->normal[w->turn > 0 ? Y : X]);
    fmb_shadow_walk_locate(w, w->here);
    for (int axis = X; axis <= Y; axis++) {
        mpq_set_z(w->q, e->normal[axis]);
        mpq_mul(w->q, w->q, w->here[axis]);
        mpq_add(e->bound, e->bound, w->q);
    }
    return add_edge_multipliers(w, e);
}

/* ---- the walk -------------------------------------------------------------------------------- */

/* Is direction a met before b when turning from w->along? All directions lie within half a turn. */
static bool is_met_first_turning(fmb_shadow_walk *w, mpz_t *a, mpz_t *b)
{
    int order = fmb_shadow_walk_cross(w, a, b) * w->turn;
    return order > 0 || (order == 0 &&
                         fmb_shadow_walk_dot(w, a, w->along) > fmb_shadow_walk_dot(w, b, w->along));
}

/* Turn to the next edge. *flat: there is none before half a turn at this vertex. Then it is
 * farthest in some direction and in the opposite one too, so the shadow has no inner points. (A
 * walk around a single point would turn for ever.) */
static void turn_to_next_edge(fmb_shadow_walk *w, bool *flat)
{
    const fmb_lp *lp = w->lp;
    bool any = false;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        if (!fmb_lp_may_enter(lp, j))
            continue;
        fmb_shadow_walk_direction(w, j, w->r);
        if (fmb_shadow_walk_is_zero(w->r) || (any && !is_met_first_turning(w, w->r, w->best)))
            continue;
        any = true;
        mpz_swap(w->r[X], w->best[X]);
        mpz_swap(w->r[Y], w->best[Y]);
    }
    int side = fmb_shadow_walk_cross(w, w->from, w->best) * w->turn;
    *flat = !any || side < 0 || (side == 0 && fmb_shadow_walk_dot(w, w->from, w->best) < 0);
    mpz_gcd(w->t, w->best[X], w->best[Y]);
    for (int axis = X; !*flat && axis <= Y; axis++)
        mpz_divexact(w->along[axis], w->best[axis], w->t);
}

/* From w->start around the shadow, until back there (*closed) or off to infinity. */
static fmb_status walk_one_way(fmb_shadow_walk *w, bool *closed, bool *flat)
{
    bool unbounded = false;
    mpq_t before[2];
    fmb_status st = FMB_OK;
    mpq_inits(before[X], before[Y], NULL);
    *closed = *flat = false;
    while (st == FMB_OK && !unbounded && !*closed) {
        turn_to_next_edge(w, flat);
        if (*flat)
            break;
        fmb_shadow_walk_locate(w, before);
        st = fmb_shadow_walk_push(w, w->along, true, &unbounded);
        if (st != FMB_OK || (!unbounded && is_shadow_at(w, before)))
            continue;
        fmb_shadow_walk_set(w->from, w->along);
        st = add_polygon_edge(w);
        *closed = !unbounded && is_shadow_at(w, w->start);
    }
    mpq_clears(before[X], before[Y], NULL);
    return st;
}

/* Does some free variable move the shadow? */
static bool has_line_in_shadow(const fmb_shadow_walk *w)
{
    const fmb_lp *lp = w->lp;
    for (size_t j = 0; j < (size_t)lp->n; j++)
        if (fmb_lp_is_x(lp, lp->column[j]) && (fmb_vec_sgn(fmb_shadow_walk_row_of(w, X), j) != 0 ||
                                               fmb_vec_sgn(fmb_shadow_walk_row_of(w, Y), j) != 0))
            return true;
    return false;
}

/* The other way from the start, where the walk now comes in on its first edge. */
static fmb_status walk_back_from_start(fmb_shadow_walk *w, mpz_t *goal, mpz_t *normal, bool *flat)
{
    bool found, closed;
    fmb_status st = fmb_shadow_walk_reach(w, goal, &found);
    if (st != FMB_OK)
        return st;
    w->turn = -1;
    mpz_neg(w->along[X], w->along[X]);
    mpz_neg(w->along[Y], w->along[Y]);
    mpz_set(w->from[X], normal[Y]);
    mpz_neg(w->from[Y], normal[X]);
    return walk_one_way(w, &closed, flat);
}

/* First against the clock; if that way leads to infinity, once more from the start with it. */
static fmb_status walk_both_ways(fmb_shadow_walk *w, mpz_t *goal, bool *done)
{
    bool closed, flat;
    size_t first = w->edges->size;
    fmb_shadow_walk_locate(w, w->start);
    w->turn = 1;
    fmb_shadow_walk_set(w->from, w->along);
    fmb_status st = walk_one_way(w, &closed, &flat);
    if (st == FMB_OK && !closed && !flat)
        st = walk_back_from_start(w, goal, w->edges->edge[first].normal, &flat);
    *done = st == FMB_OK && !flat;
    return st;
}

static fmb_status walk_from_some_vertex(fmb_shadow_walk *w, bool *done)
{
    mpz_t goal[2];
    bool found;
    mpz_inits(goal[X], goal[Y], NULL);
    fmb_status st = fmb_shadow_walk_find_start(w, goal, &found);
    if (st == FMB_OK && found)
        st = walk_both_ways(w, goal, done);
    mpz_clears(goal[X], goal[Y], NULL);
    return st;
}

fmb_status fmb_shadow_polygon(fmb_lp *lp, int i, int j, fmb_edges *out, bool *done)
{
    fmb_shadow_walk w = {.lp = lp, .var = {i, j}, .edges = out};
    *done = false;
    if (lp->any_strict || lp->where[i] >= lp->m || lp->where[j] >= lp->m || has_line_in_shadow(&w))
        return FMB_OK;
    init_walk_numbers(&w);
    fmb_status st = walk_from_some_vertex(&w, done);
    clear_walk_numbers(&w);
    return st;
}
