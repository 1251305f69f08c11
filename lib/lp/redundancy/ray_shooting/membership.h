/* membership.h: the membership program: by which factor must a hull be enlarged to contain a point?
 * In doubles: a guess.
 *
 * Points q_j of n numbers span a hull, together with the origin. The Minkowski functional of a
 * point q is the least sum of z >= 0 with sum_j z_j q_j = q; q is in the hull if that is at most 1.
 * By duality it is the largest w.q of all w with w.q_j <= 1 for every j: a program with a row a
 * point, in n columns. A basis of n points gives a vertex w; the search for another q starts there.
 */
#ifndef FMB_LP_MEMBERSHIP_H
#define FMB_LP_MEMBERSHIP_H

#include "base/mem.h"
#include "lp/simplex/simplex_methods.h"

typedef enum fmb_side_of_hull {
    FMB_HULL_NONE = 0, /* no answer: the search was stuck */
    FMB_HULL_INSIDE,   /* multipliers of the basic points: sum_r y[r] (point r) = q, sum <= 1 */
    FMB_HULL_OUTSIDE   /* way.q > 1, and way.q_j <= 1 for every point */
} fmb_side_of_hull;

typedef struct fmb_membership {
    fmb_program program;       /* rows without values, */
    fmb_scaled_program scaled; /* as they are in doubles: w.q_j <= 1 */
    fmb_simplex_state state;
    size_t n;
    int *columns; /* [n] all */
    size_t *name; /* [name_room] the caller's number of each point */
    size_t name_room;
    double *w;      /* [n] the vertex */
    double *way;    /* [n] w, or a point beyond it on an unbounded edge */
    bool is_broken; /* the vertex may be beyond the hyperplane of a point */
} fmb_membership;

/* No points, of n numbers; g must not move. Errors: MEMORY, LIMIT; call fmb_membership_clear even
 * then. */
fmb_status fmb_membership_init(fmb_membership *g, fmb_run *run, size_t n);
void fmb_membership_clear(fmb_membership *g);

/* Add a point, not longer than about 1. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_membership_add(fmb_membership *g, const double *q, size_t name);
/* Remove all points that are not in the basis. */
fmb_status fmb_membership_forget(fmb_membership *g);
/* Is q in the hull? closer: with the tightest tolerances. */
fmb_status fmb_membership_ask(fmb_membership *g, const double *q, bool closer,
                              fmb_side_of_hull *out);
/* The number of points. */
static inline size_t fmb_membership_size(const fmb_membership *g)
{
    return g->scaled.m;
}
/* The multiplier of the point at place r of the basis. */
static inline double fmb_membership_value(const fmb_membership *g, size_t r)
{
    return g->state.y[r];
}
/* The caller's name of that point; SIZE_MAX: a unit vector. */
static inline size_t fmb_membership_name(const fmb_membership *g, size_t r)
{
    size_t j = g->state.basis.member[r];
    return j < FMB_UNIT ? g->name[j] : SIZE_MAX;
}

#endif
