/* shadow_walk_private.h: what the files of the walk share; see shadow_walk.c. */
#ifndef FMB_HULL_SHADOW_WALK_PRIVATE_H
#define FMB_HULL_SHADOW_WALK_PRIVATE_H

#include "hull/shadow/shadow.h"

enum { X, Y };

typedef struct fmb_shadow_walk {
    fmb_lp *lp;
    int var[2];
    int turn;                  /* 1: against the clock, -1: with it */
    mpz_t along[2];            /* the direction of the edge just walked, or looked along */
    mpz_t from[2];             /* that in which the current vertex was reached */
    mpz_t r[2], best[2], t, u; /* scratch */
    mpq_t start[2], here[2], q;
    fmb_edges *edges;
} fmb_shadow_walk;

/* ---- the plane (shadow_walk_plane.c) --------------------------------------------------------- */

/* The dictionary row of x or y. */
static inline const fmb_vec *fmb_shadow_walk_row_of(const fmb_shadow_walk *w, int axis)
{
    return &w->lp->row[w->lp->where[w->var[axis]]];
}
static inline void fmb_shadow_walk_set(mpz_t *to, mpz_t *from)
{
    mpz_set(to[X], from[X]);
    mpz_set(to[Y], from[Y]);
}
static inline bool fmb_shadow_walk_is_zero(mpz_t *r)
{
    return mpz_sgn(r[X]) == 0 && mpz_sgn(r[Y]) == 0;
}
/* r = R_j times a positive number that is the same for all j. */
void fmb_shadow_walk_direction(fmb_shadow_walk *w, size_t j, mpz_t *r);
/* Sign of a x b: positive if b lies less than half a turn against the clock from a. And of a.b. */
int fmb_shadow_walk_cross(fmb_shadow_walk *w, mpz_t *a, mpz_t *b);
int fmb_shadow_walk_dot(fmb_shadow_walk *w, mpz_t *a, mpz_t *b);
/* The shadow of the current vertex. */
void fmb_shadow_walk_locate(fmb_shadow_walk *w, mpq_t *point);
/* Move the shadow point as far as it goes towards goal, or exactly along it. *unbounded: it goes to
 * infinity, along w->r. */
fmb_status fmb_shadow_walk_push(fmb_shadow_walk *w, mpz_t *goal, bool exactly, bool *unbounded);

/* ---- the start (shadow_walk_start.c) --------------------------------------------------------- */

/* Reach the end against the clock of the face farthest in the direction goal. *found false: there
 * is none, and w->r leads to infinity. */
fmb_status fmb_shadow_walk_reach(fmb_shadow_walk *w, mpz_t *goal, bool *found);
/* Reach a vertex of the shadow, and a goal in which it is farthest. *found false: there is none. */
fmb_status fmb_shadow_walk_find_start(fmb_shadow_walk *w, mpz_t *goal, bool *found);

#endif
