/* walk_start.c: a vertex of the shadow to start from; see walk.c.
 *
 * A shadow that is not a single face may go to infinity in most directions. Each goal that is tried
 * in vain gives a direction to infinity; the next goal points away from all of those found.
 */
#include "lp/walk_inside.h"

/* Is a column j left with goal.R_j > 0? Of those, the one of least variable. */
static size_t find_upward(fmb_walk *w, mpz_t *goal)
{
    const fmb_lp *lp = w->lp;
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        if (!fmb_lp_may_enter(lp, j))
            continue;
        fmb_walk_direction(w, j, w->r);
        if (fmb_walk_dot(w, goal, w->r) > 0 &&
            (best == SIZE_MAX || lp->column[j] < lp->column[best]))
            best = j;
    }
    return best;
}

/* Move the shadow point as far as it goes in the direction goal. *bounded false: it goes to
 * infinity, along w->r. */
static fmb_status climb(fmb_walk *w, mpz_t *goal, bool *bounded)
{
    for (;;) {
        size_t j = find_upward(w, goal);
        size_t block = j == SIZE_MAX ? 0 : fmb_lp_find_block(w->lp, j, 1);
        *bounded = j == SIZE_MAX;
        if (*bounded)
            return FMB_OK;
        if (block == SIZE_MAX) {
            fmb_walk_direction(w, j, w->r);
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
static bool widen(fmb_walk *w, sector *s)
{
    if (s->sides == 0) {
        shorten(s->side[0], w->r);
        shorten(s->side[1], w->r);
        s->sides = 1;
        return true;
    }
    int before = fmb_walk_cross(w, s->side[0], w->r), after = fmb_walk_cross(w, s->side[1], w->r);
    if (before < 0 && after < 0)
        shorten(s->side[0], w->r);
    else if (before > 0 && after > 0)
        shorten(s->side[1], w->r);
    else if (before <= 0 || after >= 0)
        return false;
    return true;
}

/* Add |size| a, turned by a quarter against the clock (sign 1) or with it (-1). */
static void add_turned(fmb_walk *w, mpz_t *to, mpz_t *a, int sign, mpz_t *size)
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
static void oppose(fmb_walk *w, sector *s, mpz_t *goal)
{
    mpz_set_ui(goal[X], 0);
    mpz_set_ui(goal[Y], 0);
    if (fmb_walk_cross(w, s->side[0], s->side[1]) == 0) {
        fmb_walk_set(goal, s->side[0]);
    } else {
        add_turned(w, goal, s->side[0], 1, s->side[1]);
        add_turned(w, goal, s->side[1], -1, s->side[0]);
    }
    mpz_neg(goal[X], goal[X]);
    mpz_neg(goal[Y], goal[Y]);
    shorten(goal, goal);
}

fmb_status fmb_walk_reach(fmb_walk *w, mpz_t *goal, bool *found)
{
    bool unbounded = false;
    fmb_status st = climb(w, goal, found);
    if (st != FMB_OK || !*found)
        return st;
    mpz_neg(w->along[X], goal[Y]);
    mpz_set(w->along[Y], goal[X]);
    st = fmb_walk_slide(w, &unbounded);
    *found = !unbounded;
    if (unbounded)
        fmb_walk_set(w->r, w->along);
    return st;
}

/* Every try that fails finds an edge to infinity outside of the sector of those found before, and
 * there are only so many of them. */
static fmb_status try_goals(fmb_walk *w, mpz_t *goal, sector *s, bool *found)
{
    mpz_set_si(goal[X], 1);
    mpz_set_si(goal[Y], 0);
    for (;;) {
        fmb_status st = fmb_walk_reach(w, goal, found);
        if (st != FMB_OK || *found || !widen(w, s))
            return st;
        oppose(w, s, goal);
    }
}

fmb_status fmb_walk_find_start(fmb_walk *w, mpz_t *goal, bool *found)
{
    sector s = {0};
    for (int k = 0; k < 2; k++)
        mpz_inits(s.side[k][X], s.side[k][Y], NULL);
    fmb_status st = try_goals(w, goal, &s, found);
    for (int k = 0; k < 2; k++)
        mpz_clears(s.side[k][X], s.side[k][Y], NULL);
    return st;
}
