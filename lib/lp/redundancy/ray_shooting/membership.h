/* membership.h: the membership program: by which factor must a hull be enlarged to contain a point?
 * In doubles: a guess.
 *
 * Points q_j of n numbers span a hull, together with the origin. The Minkowski functional of a
 * point q is the least sum of z >= 0 with sum_j z_j q_j = q; q is in the hull if that is at most 1.
 * By duality it is the largest w.q of all w with w.q_j <= 1 for every j. A basis of n points gives
 * a vertex w of these; the search for another q starts from there.
 */
#ifndef FMB_LP_MEMBERSHIP_H
#define FMB_LP_MEMBERSHIP_H

#include "base/mem.h"
#include "lp/simplex/simplex.h"

typedef enum fmb_side_of_hull {
    FMB_HULL_NONE = 0, /* no answer: the search was stuck */
    FMB_HULL_INSIDE,   /* values of the basic points: sum_r value[r] (point r) = q, sum <= 1 */
    FMB_HULL_OUTSIDE   /* way.q > 1, and way.q_j <= 1 for every point */
} fmb_side_of_hull;

/* To have a vertex from the start, w begins in the corner of a large cube: unit vectors, or their
 * negatives, each of which costs as much as `cube` points. */
typedef struct fmb_membership {
    fmb_basis basis; /* of points */
    size_t n;
    double cube;  /* initial |w_k| */
    double zero;  /* values between -zero and 0 count as 0 */
    size_t *name; /* [name_room] the caller's number of each point */
    size_t name_room;
    double *w;      /* [n] the vertex */
    double *way;    /* [n] w, or a point beyond it on an unbounded edge; also scratch */
    bool is_broken; /* the vertex may be beyond the hyperplane of a point */
} fmb_membership;

/* No points, of n numbers. Errors: MEMORY, LIMIT; call fmb_membership_clear even then. */
fmb_status fmb_membership_init(fmb_membership *g, fmb_mem *mem, const fmb_kernels *kernels,
                               size_t n, double cube);
void fmb_membership_clear(fmb_membership *g);

/* Add a point. Errors: MEMORY, LIMIT. */
fmb_status fmb_membership_add(fmb_membership *g, const double *q, size_t name);
/* Remove all points that are not in the basis. */
void fmb_membership_forget(fmb_membership *g);
/* Take another cube; the search starts afresh. */
void fmb_membership_resize_cube(fmb_membership *g, double cube);
/* Is q in the hull? run may be NULL. Errors: LIMIT. */
fmb_status fmb_membership_ask(fmb_membership *g, const double *q, fmb_run *run,
                              fmb_side_of_hull *out);
/* The caller's name of the point at place r of the basis; SIZE_MAX: a unit vector. */
static inline size_t fmb_membership_name(const fmb_membership *g, size_t r)
{
    return g->basis.basic[r] == SIZE_MAX ? SIZE_MAX : g->name[g->basis.basic[r]];
}

#endif
