/* ray.h: a ray from the interior point: the row that it meets first, and a point just beyond that.
 *
 * In direction w, row i is met at the time 1 / (w.p_i), so before all others if w.p_i is the
 * largest. Such a row is irredundant, since a point just beyond it violates this row and no other.
 * That a row is met first is proved: by bounds on the errors of doubles, or in integers if these do
 * not suffice.
 */
#ifndef FMB_LP_RAY_H
#define FMB_LP_RAY_H

#include "lp/redundancy/ray_shooting/polar_points.h"

/* Most rows whose times are compared exactly; if there are more, a ray gives no answer. */
#define FMB_RAY_TRIES 64

typedef struct fmb_ray {
    fmb_run *run;
    const fmb_polar_points *p;
    mpz_t *way; /* [d] its direction: way / 2^unit */
    int unit;
    double *scaled; /* [d] the same in scaled columns */
    double *aside;  /* [d] scratch */
    double *bound;  /* [blocks] scratch */
    double *rate;   /* [m] w.p_i in doubles, in the blocks visited */
    size_t hit;     /* the row that the ray met */
    size_t *tried;  /* rows that may be first, including hit */
    size_t tries;
    double rest; /* all other rows have smaller rates than this */
} fmb_ray;

/* p must outlive r. Errors: MEMORY, LIMIT; call fmb_ray_clear even then. */
fmb_status fmb_ray_init(fmb_ray *r, fmb_run *run, const fmb_polar_points *p);
void fmb_ray_clear(fmb_ray *r);

/* The row that a ray in direction way[d], in round coordinates, meets first; of several at once,
 * one that a nearby ray meets alone. SIZE_MAX: there is none, it was not decided, or a limit was
 * reached. `roughly` rounds the direction, which gives points with shorter numbers. */
size_t fmb_ray_shoot(fmb_ray *r, const double *way, bool roughly);
/* x[n]: a point beyond the row that the last ray met, and beyond no other. Errors: LIMIT. */
fmb_status fmb_ray_beyond(fmb_ray *r, mpq_t *x);

#endif
