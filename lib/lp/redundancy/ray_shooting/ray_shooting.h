/* ray_shooting.h: which rows are redundant and which are not, of many rows with a point strictly
 * inside.
 *
 * Guessed in doubles, proved in integers. A row that goes is a combination of rows that are proved
 * to be irredundant: so what becomes of a row does not depend on the order of the tests, nor on who
 * makes them.
 */
#ifndef FMB_LP_RAY_SHOOTING_H
#define FMB_LP_RAY_SHOOTING_H

#include "lp/redundancy/irredundant.h"
#include "lp/redundancy/ray_shooting/polar_points.h"

typedef struct fmb_ray_shooting {
    fmb_run *run;
    fmb_polar_points points;
    fmb_fate *fate;           /* [m] the caller's */
    const fmb_verdicts *told; /* the caller's, or NULL */
} fmb_ray_shooting;

/* A look for a point strictly inside takes steps of n^2 m multiplications: is that a fraction of a
 * second at most? A limit has to wait for one. */
bool fmb_ray_shooting_is_affordable(size_t n, size_t m);
/* row must outlive s. *inner: there is a point strictly inside, proved; else there may be one
 * (equalities leave none). Errors: MEMORY, LIMIT. In any case fmb_ray_shooting_close it. */
fmb_status fmb_ray_shooting_open(fmb_ray_shooting *s, fmb_run *run, size_t n, size_t m,
                                 const fmb_lp_row *row, bool *inner);
void fmb_ray_shooting_close(fmb_ray_shooting *s);
/* With a point inside: fate[m], UNKNOWN on entry, becomes KEPT or REDUNDANT; a few rows may stay
 * UNKNOWN. told may be NULL. Where the run has several threads, they sort many rows; what
 * becomes of them, and what is told, is the same for any number of these. On LIMIT the fates set so
 * far hold. Errors: MEMORY, LIMIT. */
fmb_status fmb_ray_shooting_sort(fmb_ray_shooting *s, fmb_fate *fate, const fmb_verdicts *told);

#endif
