/* shadow_walk_start.c: a vertex of the shadow to start from; see shadow_walk.c.
 *
 * A shadow that is not a single face may go to infinity in most directions. Each goal that is tried
 * in vain gives a direction to infinity; the next goal points away from all of those found.
 */
#include "hull/shadow/shadow_walk_private.h"

/* The directions to infinity found so far all lie between side[0] and side[1], against the clock.
 */
typedef struct sector {
    mpz_t side[2][2];
    int sides;
} sector;

/* to = from without the common factor; to may be from. */
static void divide_by_gcd(mpz_t *to, mpz_t *from)
{
    mpz_t g;
    mpz_init(g);
    mpz_gcd(g, from[X], from[Y]);
    mpz_divexact(to[X], from[X], g);
    mpz_divexact(to[Y], from[Y], g);
    mpz_clear(g);
}

/* Take w->r into the sector; false if it then has half a turn or more. */
static bool widen_sector(fmb_shadow_walk *w, sector *s)
{
    if (s->sides == 0) {
        divide_by_gcd(s->side[0], w->r);
        divide_by_gcd(s->side[1], w->r);
        s->sides = 1;
        return true;
    }
    int before = fmb_shadow_walk_cross(w, s->side[0], w->r),
        after = fmb_shadow_walk_cross(w, s->side[1], w->r);
    if (before < 0 && after < 0)
        divide_by_gcd(s->side[0], w->r);
    else if (before > 0 && after > 0)
        divide_by_gcd(s->side[1], w->r);
    else if (before <= 0 || after >= 0)
        return false;
    return true;
}

/* Add |size| a, turned by a quarter against the clock (sign 1) or with it (-1). */
static void add_quarter_turn(fmb_shadow_walk *w, mpz_t *to, mpz_t *a, int sign, mpz_t *size)
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
static void aim_against_sector(fmb_shadow_walk *w, sector *s, mpz_t *goal)
{
    mpz_set_ui(goal[X], 0);
    mpz_set_ui(goal[Y], 0);
    if (fmb_shadow_walk_cross(w, s->side[0], s->side[1]) == 0) {
        fmb_shadow_walk_set(goal, s->side[0]);
    } else {
        add_quarter_turn(w, goal, s->side[0], 1, s->side[1]);
        add_quarter_turn(w, goal, s->side[1], -1, s->side[0]);
    }
    mpz_neg(goal[X], goal[X]);
    mpz_neg(goal[Y], goal[Y]);
    divide_by_gcd(goal, goal);
}

fmb_status fmb_shadow_walk_reach(fmb_shadow_walk *w, mpz_t *goal, bool *found)
{
    bool unbounded;
    fmb_status st = fmb_shadow_walk_push(w, goal, false, &unbounded);
    if (st == FMB_OK && !unbounded) {
        mpz_neg(w->along[X], goal[Y]);
        mpz_set(w->along[Y], goal[X]);
        st = fmb_shadow_walk_push(w, w->along, true, &unbounded);
    }
    *found = !unbounded;
    return st;
}

/* Every try that fails finds an edge to infinity outside of the sector of those found before, and
 * there are only so many of them. */
static fmb_status try_goals_in_turn(fmb_shadow_walk *w, mpz_t *goal, sector *s, bool *found)
{
    mpz_set_si(goal[X], 1);
    mpz_set_si(goal[Y], 0);
    for (;;) {
        fmb_status st = fmb_shadow_walk_reach(w, goal, found);
        if (st != FMB_OK || *found || !widen_sector(w, s))
            return st;
        aim_against_sector(w, s, goal);
    }
}

fmb_status fmb_shadow_walk_find_start(fmb_shadow_walk *w, mpz_t *goal, bool *found)
{
    sector s = {0};
    for (int k = 0; k < 2; k++)
        mpz_inits(s.side[k][X], s.side[k][Y], NULL);
    fmb_status st = try_goals_in_turn(w, goal, &s, found);
    for (int k = 0; k < 2; k++)
        mpz_clears(s.side[k][X], s.side[k][Y], NULL);
    return st;
}
