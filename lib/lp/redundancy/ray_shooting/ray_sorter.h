/* ray_sorter.h: decides rows in a range of places of the polar points; see ray_shooting.h. */
#ifndef FMB_LP_RAY_SORTER_H
#define FMB_LP_RAY_SORTER_H

#include "lp/linalg/exact/combination.h"
#include "lp/redundancy/irredundant.h"
#include "lp/redundancy/ray_shooting/membership.h"
#include "lp/redundancy/ray_shooting/ray.h"

typedef struct fmb_ray_sorter {
    fmb_run *run;
    const fmb_polar_points *points;
    fmb_ray ray;
    fmb_membership membership; /* of irredundant rows, or of some of them if there are many */
    fmb_combination combination;
    fmb_fate *fate;           /* [m] the caller's */
    const fmb_verdicts *told; /* the caller's, or NULL */
    size_t known, capacity;   /* rows known to be irredundant */
    size_t *name;             /* [capacity] the rows */
    double *at;               /* [d][capacity] their polar points, in round coordinates */
    double *score;            /* [capacity] scratch */
    bool *is_active;          /* [m] in the membership program */
    double *target;           /* [d] the row being tested */
    size_t *support;          /* [d] scratch */
    mpq_t *x;                 /* [n] scratch */
} fmb_ray_sorter;

/* fate[m] is UNKNOWN for the rows to be decided. Errors: MEMORY, LIMIT. The caller must call
 * fmb_ray_sorter_clear even then. */
fmb_status fmb_ray_sorter_init(fmb_ray_sorter *s, fmb_run *run, const fmb_polar_points *points,
                               fmb_fate *fate, const fmb_verdicts *told);
void fmb_ray_sorter_clear(fmb_ray_sorter *s);
/* Rows at the places from, ..., to - 1 become KEPT or REDUNDANT; a few may stay UNKNOWN; other rows
 * may become KEPT. On LIMIT the fates set so far are valid. Errors: MEMORY, LIMIT. */
fmb_status fmb_ray_sorter_sort(fmb_ray_sorter *s, size_t from, size_t to);

#endif
