/* witness.h: back-substitution: from values of the variables kept to values of those eliminated. */
#ifndef FMB_ELIM_WITNESS_H
#define FMB_ELIM_WITNESS_H

#include "elim/store/store.h"

typedef enum fmb_point_kind {
    FMB_POINT_INSIDE = 0, /* satisfies every row */
    FMB_POINT_CLOSURE,    /* strict rows hold with <= only */
    FMB_POINT_RAY         /* a direction: right sides count as 0, strict rows as <= */
} fmb_point_kind;

/* x[n] holds values of the variables not eliminated that satisfy the live rows (in the sense of
 * kind); the others are set so that x satisfies every base row. They are chosen simple: 0, else an
 * integer, where there is room. */
fmb_status fmb_elim_point(const fmb_elim *e, fmb_point_kind kind, mpq_t *x);

/* A simple rational between the ends (NULL = none); an open end is not taken. There must be one. */
void fmb_simple_between(mpq_t x, mpq_srcptr lower, bool lower_open, mpq_srcptr upper,
                        bool upper_open);

#endif
