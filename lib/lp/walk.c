/* walk.c: the shadow vertex method; see walk.h.
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
#include "lp/walk.h"

enum { X, Y };

typedef struct walk {
    fmb_lp *lp;
    int var[2];
    int turn;                  /* 1: against the clock, -1: with it */
    mpz_t along[2];            /* the direction of the edge just walked, or looked along */
    mpz_t from[2];             /* that in which the current vertex was reached */
    mpz_t r[2], best[2], t, u; /* scratch */
    mpq_t start[2], here[2], q;
    fmb_edges *edges;
} walk;

static void walk_init(walk *w)
{
    mpz_inits(w->along[X], w->along[Y], w->from[X], w->from[Y], w->r[X], w->r[Y], w->best[X],
              w->best[Y], w->t, w->u, NULL);
    mpq_inits(w->start[X], w->start[Y], w->here[X], w->here[Y], w->q, NULL);
}

static void walk_clear(walk *w)
{
    mpz_clears(w->along[X], w->along[Y], w->from[X], w->from[Y], w->r[X], w->r[Y], w->best[X],
               w->best[Y], w->t, w->u, NULL);
    mpq_clears(w->start[X], w->start[Y], w->here[X], w->here[Y], w->q, NULL);
}

static const fmb_vec *row_of(const walk *w, int axis)
{
    return &w->lp->row[w->lp->where[w->var[axis]]];
}

/* r = R_j times a positive number that is the same for all j: x = sum (c_xj / d_x) N_j, so both are
 * multiplied by d_x d_y. */
static void direction(walk *w, size_t j, mpz_t *r)
{
    for (int axis = X; axis <= Y; axis++) {
        fmb_vec_get(row_of(w, axis), j, r[axis]);
        fmb_vec_get(row_of(w, 1 - axis), fmb_lp_place(w->lp, FMB_LP_OWN), w->t);
        mpz_mul(r[axis], r[axis], w->t);
        mpz_neg(r[axis], r[axis]);
    }
}

static void set(mpz_t *to, mpz_t *from)
{
    mpz_set(to[X], from[X]);
    mpz_set(to[Y], from[Y]);
}

static bool is_zero(mpz_t *r)
{
    return mpz_sgn(r[X]) == 0 && mpz_sgn(r[Y]) == 0;
}

/* Sign of a x b: positive if b lies less than half a turn against the clock from a. */
static int cross(walk *w, mpz_t *a, mpz_t *b)
{
    mpz_mul(w->t, a[X], b[Y]);
    mpz_mul(w->u, a[Y], b[X]);
    return mpz_cmp(w->t, w->u);
}

static int dot(walk *w, mpz_t *a, mpz_t *b)
{
    mpz_mul(w->t, a[X], b[X]);
    mpz_mul(w->u, a[Y], b[Y]);
    mpz_add(w->t, w->t, w->u);
    return mpz_sgn(w->t);
}

/* The shadow of the current vertex. */
static void locate(walk *w, mpq_t *point)
{
    for (int axis = X; axis <= Y; axis++) {
        fmb_vec_get(row_of(w, axis), fmb_lp_place(w->lp, FMB_LP_K), mpq_numref(point[axis]));
        fmb_vec_get(row_of(w, axis), fmb_lp_place(w->lp, FMB_LP_OWN), mpq_denref(point[axis]));
        mpz_neg(mpq_denref(point[axis]), mpq_denref(point[axis]));
        mpq_canonicalize(point[axis]);
    }
}

static bool is_at(walk *w, mpq_t *point)
{
    locate(w, w->here);
    return mpq_equal(w->here[X], point[X]) && mpq_equal(w->here[Y], point[Y]);
}

/* ---- edges ----------------------------------------------------------------------------------- */

/* The multiplier -normal.R_j of every nonbasic slack. */
static fmb_status add_weights(walk *w, fmb_edge *e)
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
            fmb_vec_get(row_of(w, axis), j, mpq_numref(w->q));
            fmb_vec_get(row_of(w, axis), fmb_lp_place(lp, FMB_LP_OWN), mpq_denref(w->q));
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
static fmb_status add_edge(walk *w)
{
    fmb_edges *list = w->edges;
    fmb_status st = fmb_mem_reserve(w->lp->run->mem, (void **)&list->edge, &list->capacity,
                                    list->size + 1, sizeof *list->edge);
    if (st != FMB_OK)
        return st;
    fmb_edge *e = &list->edge[list->size++];
    *e = (fmb_edge){0};
    mpz_inits(e->normal[X], e->normal[Y], NULL);
    mpq_init(e->bound);
    mpz_gcd(w->t, w->along[X], w->along[Y]);
    mpz_divexact(e->normal[X], w->along[Y], w->t);
    mpz_divexact(e->normal[Y], w->along[X], w->t);
    mpz_neg(e->normal[w->turn > 0 ? Y : X], e->normal[w->turn > 0 ? Y : X]);
    locate(w, w->here);
    for (int axis = X; axis <= Y; axis++) {
        mpq_set_z(w->q, e->normal[axis]);
        mpq_mul(w->q, w->q, w->here[axis]);
        mpq_add(e->bound, e->bound, w->q);
    }
    return add_weights(w, e);
}

/* ---- the walk -------------------------------------------------------------------------------- */

/* The column that moves the shadow along w->along, of least variable (Bland's rule: no cycles);
 * SIZE_MAX if none does. */
static size_t find_onward(walk *w)
{
    const fmb_lp *lp = w->lp;
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        if (!fmb_lp_may_enter(lp, j))
            continue;
        direction(w, j, w->r);
        if (!is_zero(w->r) && cross(w, w->along, w->r) == 0 && dot(w, w->along, w->r) > 0 &&
            (best == SIZE_MAX || lp->column[j] < lp->column[best]))
            best = j;
    }
    return best;
}

/* Walk on along w->along as far as it goes. */
static fmb_status slide(walk *w, bool *unbounded)
{
    *unbounded = false;
    for (;;) {
        size_t j = find_onward(w);
        if (j == SIZE_MAX)
            return FMB_OK;
        size_t block = fmb_lp_find_block(w->lp, j, 1);
        *unbounded = block == SIZE_MAX;
        fmb_status st = *unbounded ? FMB_OK : fmb_lp_pivot(w->lp, block, j);
        if (st != FMB_OK || *unbounded)
            return st;
    }
}

/* Is direction a met before b when turning from w->along? All directions lie within half a turn. */
static bool is_met_first(walk *w, mpz_t *a, mpz_t *b)
{
    int order = cross(w, a, b) * w->turn;
    return order > 0 || (order == 0 && dot(w, a, w->along) > dot(w, b, w->along));
}

/* Turn to the next edge. *flat: there is none before half a turn at this vertex. Then it is
 * farthest in some direction and in the opposite one too, so the shadow has no inner points. (A
 * walk around a single point would turn for ever.) */
static void turn(walk *w, bool *flat)
{
    const fmb_lp *lp = w->lp;
    bool any = false;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        if (!fmb_lp_may_enter(lp, j))
            continue;
        direction(w, j, w->r);
        if (is_zero(w->r) || (any && !is_met_first(w, w->r, w->best)))
            continue;
        any = true;
        mpz_swap(w->r[X], w->best[X]);
        mpz_swap(w->r[Y], w->best[Y]);
    }
    int side = cross(w, w->from, w->best) * w->turn;
    *flat = !any || side < 0 || (side == 0 && dot(w, w->from, w->best) < 0);
    mpz_gcd(w->t, w->best[X], w->best[Y]);
    for (int axis = X; !*flat && axis <= Y; axis++)
        mpz_divexact(w->along[axis], w->best[axis], w->t);
}

/* From w->start around the shadow, until back there (*closed) or off to infinity. */
static fmb_status go_round(walk *w, bool *closed, bool *flat)
{
    bool unbounded = false;
    mpq_t before[2];
    fmb_status st = FMB_OK;
    mpq_inits(before[X], before[Y], NULL);
    *closed = *flat = false;
    while (st == FMB_OK && !unbounded && !*closed) {
        turn(w, flat);
        if (*flat)
            break;
        locate(w, before);
        st = slide(w, &unbounded);
        if (st != FMB_OK || (!unbounded && is_at(w, before)))
            continue;
        set(w->from, w->along);
        st = add_edge(w);
        *closed = !unbounded && is_at(w, w->start);
    }
    mpq_clears(before[X], before[Y], NULL);
    return st;
}

/* Does some free variable move the shadow? */
static bool has_line(const walk *w)
{
    const fmb_lp *lp = w->lp;
    for (size_t j = 0; j < (size_t)lp->n; j++)
        if (fmb_lp_is_x(lp, lp->column[j]) &&
            (fmb_vec_sgn(row_of(w, X), j) != 0 || fmb_vec_sgn(row_of(w, Y), j) != 0))
            return true;
    return false;
}

/* Is a column j left with goal.R_j > 0? Of those, the one of least variable. */
static size_t find_upward(walk *w, mpz_t *goal)
{
    const fmb_lp *lp = w->lp;
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        if (!fmb_lp_may_enter(lp, j))
            continue;
        direction(w, j, w->r);
        if (dot(w, goal, w->r) > 0 && (best == SIZE_MAX || lp->column[j] < lp->column[best]))
            best = j;
    }
    return best;
}

/* Move the shadow point as far as it goes in the direction goal. *bounded false: it goes to
 * infinity, along w->r. */
static fmb_status climb(walk *w, mpz_t *goal, bool *bounded)
{
    for (;;) {
        size_t j = find_upward(w, goal);
        size_t block = j == SIZE_MAX ? 0 : fmb_lp_find_block(w->lp, j, 1);
        *bounded = j == SIZE_MAX;
        if (*bounded)
            return FMB_OK;
        if (block == SIZE_MAX) {
            direction(w, j, w->r);
            return FMB_OK;
        }
        fmb_status st = fmb_lp_pivot(w->lp, block, j);
        if (st != FMB_OK)
            return st;
    }
}

/* The directions to infinity found so far all lie between side[0] and side[1], against the clock.
 */
typedef struct sector {
    mpz_t side[2][2];
    int sides;
} sector;

/* to = from without the common factor; to may be from. */
static void shorten(mpz_t *to, mpz_t *from)
{
    mpz_t g;
    mpz_init(g);
    mpz_gcd(g, from[X], from[Y]);
    mpz_divexact(to[X], from[X], g);
    mpz_divexact(to[Y], from[Y], g);
    mpz_clear(g);
}

/* Take w->r into the sector; false if it then has half a turn or more. */
static bool widen(walk *w, sector *s)
{
    if (s->sides == 0) {
        shorten(s->side[0], w->r);
        shorten(s->side[1], w->r);
        s->sides = 1;
        return true;
    }
    int before = cross(w, s->side[0], w->r), after = cross(w, s->side[1], w->r);
    if (before < 0 && after < 0)
        shorten(s->side[0], w->r);
    else if (before > 0 && after > 0)
        shorten(s->side[1], w->r);
    else if (before <= 0 || after >= 0)
        return false;
    return true;
}

/* Add |size| a, turned by a quarter against the clock (sign 1) or with it (-1). */
static void add_turned(walk *w, mpz_t *to, mpz_t *a, int sign, mpz_t *size)
{
    mpz_abs(w->t, size[X]);
    mpz_abs(w->u, size[Y]);
    mpz_add(w->t, w->t, w->u);
    if (sign < 0)
        mpz_neg(w->t, w->t);
    mpz_submul(to[X], a[Y], w->t);
    mpz_addmul(to[Y], a[X], w->t);
}

/* A goal strictly against all of the sector, near the middle of all such: its sides, each turned by
 * a quarter towards the other, add up to a direction at less than a quarter from both. */
static void oppose(walk *w, sector *s, mpz_t *goal)
{
    mpz_set_ui(goal[X], 0);
    mpz_set_ui(goal[Y], 0);
    if (cross(w, s->side[0], s->side[1]) == 0) {
        set(goal, s->side[0]);
    } else {
        add_turned(w, goal, s->side[0], 1, s->side[1]);
        add_turned(w, goal, s->side[1], -1, s->side[0]);
    }
    mpz_neg(goal[X], goal[X]);
    mpz_neg(goal[Y], goal[Y]);
    shorten(goal, goal);
}

/* Reach the end against the clock of the face farthest in the direction goal. *found false: there
 * is none, and w->r leads to infinity. */
static fmb_status reach(walk *w, mpz_t *goal, bool *found)
{
    bool unbounded = false;
    fmb_status st = climb(w, goal, found);
    if (st != FMB_OK || !*found)
        return st;
    mpz_neg(w->along[X], goal[Y]);
    mpz_set(w->along[Y], goal[X]);
    st = slide(w, &unbounded);
    *found = !unbounded;
    if (unbounded)
        set(w->r, w->along);
    return st;
}

/* Reach a vertex of the shadow, and a goal in which it is farthest. *found false: there is none.
 * Every try that fails finds an edge to infinity outside of the sector of those found before, and
 * there are only so many of them. */
static fmb_status find_start(walk *w, mpz_t *goal, sector *s, bool *found)
{
    mpz_set_si(goal[X], 1);
    for (;;) {
        fmb_status st = reach(w, goal, found);
        if (st != FMB_OK || *found || !widen(w, s))
            return st;
        oppose(w, s, goal);
    }
}

/* The other way from the start, where the walk now comes in on its first edge. */
static fmb_status go_back(walk *w, mpz_t *goal, mpz_t *normal, bool *flat)
{
    bool found, closed;
    fmb_status st = reach(w, goal, &found);
    if (st != FMB_OK)
        return st;
    w->turn = -1;
    mpz_neg(w->along[X], w->along[X]);
    mpz_neg(w->along[Y], w->along[Y]);
    mpz_set(w->from[X], normal[Y]);
    mpz_neg(w->from[Y], normal[X]);
    return go_round(w, &closed, flat);
}

/* First against the clock; if that way leads to infinity, once more from the start with it. */
static fmb_status walk_both_ways(walk *w, mpz_t *goal, bool *done)
{
    bool closed, flat;
    size_t first = w->edges->size;
    locate(w, w->start);
    w->turn = 1;
    set(w->from, w->along);
    fmb_status st = go_round(w, &closed, &flat);
    if (st == FMB_OK && !closed && !flat)
        st = go_back(w, goal, w->edges->edge[first].normal, &flat);
    *done = st == FMB_OK && !flat;
    return st;
}

static fmb_status walk_somehow(walk *w, bool *done)
{
    sector s = {0};
    mpz_t goal[2];
    bool found;
    mpz_inits(goal[X], goal[Y], NULL);
    for (int k = 0; k < 2; k++)
        mpz_inits(s.side[k][X], s.side[k][Y], NULL);
    fmb_status st = find_start(w, goal, &s, &found);
    if (st == FMB_OK && found)
        st = walk_both_ways(w, goal, done);
    for (int k = 0; k < 2; k++)
        mpz_clears(s.side[k][X], s.side[k][Y], NULL);
    mpz_clears(goal[X], goal[Y], NULL);
    return st;
}

fmb_status fmb_lp_walk(fmb_lp *lp, int i, int j, fmb_edges *out, bool *done)
{
    walk w = {.lp = lp, .var = {i, j}, .edges = out};
    *done = false;
    if (lp->any_strict || lp->where[i] >= lp->m || lp->where[j] >= lp->m || has_line(&w))
        return FMB_OK;
    walk_init(&w);
    fmb_status st = walk_somehow(&w, done);
    walk_clear(&w);
    return st;
}

void fmb_edges_clear(fmb_edges *list, fmb_mem *mem)
{
    for (size_t k = 0; k < list->size; k++) {
        mpz_clears(list->edge[k].normal[X], list->edge[k].normal[Y], NULL);
        mpq_clear(list->edge[k].bound);
        fmb_weights_clear(&list->edge[k].w, mem);
    }
    fmb_mem_put(mem, list->edge, list->capacity, sizeof *list->edge);
    *list = (fmb_edges){0};
}
