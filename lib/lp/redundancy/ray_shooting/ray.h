/* ray.h: a ray from the point that rows are seen from: which row it meets first, and points behind
 * that.
 *
 * In direction w, row i is met at the time 1 / (w.p_i), so before all others if w.p_i is the
 * largest. Such a row is irredundant, since just behind it lies a point that breaks it and no
 * other. That a row is met first is proved: by bounds on the errors of doubles, and in integers
 * where these do not tell.
 */
#ifndef FMB_LP_RAY_H
#define FMB_LP_RAY_H

#include "lp/redundancy/ray_shooting/polar_points.h"

/* Rows whose times are compared exactly; if there are more, a ray says nothing. */
#define FMB_RAY_TRIES 64

typedef struct fmb_ray {
    fmb_run *run;
    const fmb_polar_points *p;
    mpz_t *way; /* [d] its direction: way / 2^unit */
    int unit;
    double *scaled; /* [d] the same in scaled columns */
    double *aside;  /* [d] scratch */
    double *bound;  /* [blocks] scratch */
    double *rate;   /* [m] w.p_i, roughly, in blocks that were looked at */
    size_t hit;     /* the row that it met */
    size_t *tried;  /* rows that might have been the first, hit among them */
    size_t tries;
    double rest; /* all other rows have smaller rates than this */
} fmb_ray;

/* p must outlive r. Errors: MEMORY, LIMIT. In any case fmb_ray_clear it. */
fmb_status fmb_ray_init(fmb_ray *r, fmb_run *run, const fmb_polar_points *p);
void fmb_ray_clear(fmb_ray *r);

/* The row that a ray in direction way[d], in round coordinates, meets first: of several at once,
 * one that a ray close by meets alone. SIZE_MAX: none, or that did not come out, or a limit was
 * reached. A direction taken roughly gives points with shorter numbers. */
size_t fmb_ray_shoot(fmb_ray *r, const double *way, bool roughly);
/* A point beyond the row that the last ray met, and beyond no other, x[n]. Errors: LIMIT. */
fmb_status fmb_ray_beyond(fmb_ray *r, mpq_t *x);

#endif
