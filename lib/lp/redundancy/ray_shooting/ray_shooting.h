/* ray_shooting.h: redundant and irredundant rows, among many rows with a point strictly inside.
 *
 * Guessed in doubles, proved in integers. A row is removed as a combination of rows proved
 * irredundant: so the fate of a row depends neither on the order of the tests nor on the thread
 * that makes them.
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

/* The search for a point strictly inside takes steps of n^2 m multiplications: is a step a fraction
 * of a second at most? A limit has to wait for its end. */
bool fmb_ray_shooting_is_affordable(size_t n, size_t m);
/* row must outlive s. *inner: there is a point strictly inside, proved; else there may be one (not
 * with equalities). Errors: MEMORY, LIMIT; call fmb_ray_shooting_close even then. */
fmb_status fmb_ray_shooting_open(fmb_ray_shooting *s, fmb_run *run, size_t n, size_t m,
                                 const fmb_lp_row *row, bool *inner);
void fmb_ray_shooting_close(fmb_ray_shooting *s);
/* If there is a point inside: fate[m], UNKNOWN on entry, becomes KEPT or REDUNDANT; a few rows may
 * stay UNKNOWN. told may be NULL. If the run has several threads, they share many rows; fates and
 * notifications are the same for any number of threads. On LIMIT the fates set so far are valid.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_ray_shooting_sort(fmb_ray_shooting *s, fmb_fate *fate, const fmb_verdicts *told);

#endif
