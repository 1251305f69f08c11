/* witness.h: back-substitution: extends values of the kept variables to the eliminated ones. */
#ifndef FMB_ELIM_WITNESS_H
#define FMB_ELIM_WITNESS_H

#include "elim/store/store.h"

typedef enum fmb_point_kind {
    FMB_POINT_INSIDE = 0, /* satisfies every row */
    FMB_POINT_CLOSURE,    /* strict rows count as <= */
    FMB_POINT_RAY         /* a direction: right sides count as 0, strict rows as <= */
} fmb_point_kind;

/* x[n] holds values of the kept variables that satisfy the live rows (in the sense of kind); set
 * the others so that x satisfies every base row. Simple values are preferred: 0, else an integer,
 * if the bounds allow it. */
fmb_status fmb_elim_point(const fmb_elim *e, fmb_point_kind kind, mpq_t *x);

/* A simple rational between two ends (NULL: none), excluding open ends. The range is not empty. */
void fmb_simple_between(mpq_t x, mpq_srcptr lower, bool lower_open, mpq_srcptr upper,
                        bool upper_open);

#endif
