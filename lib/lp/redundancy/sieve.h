/* sieve.h: which rows are redundant and which are not, of many rows with a point strictly inside.
 *
 * Guessed in doubles, proved in integers. A row that goes is a combination of rows that are proved
 * to be irredundant: so what becomes of a row does not depend on the order of the tests.
 */
#ifndef FMB_LP_SIEVE_H
#define FMB_LP_SIEVE_H

#include "lp/exact/combination.h"
#include "lp/float/gauge.h"
#include "lp/redundancy/irredundant.h"
#include "lp/redundancy/polar.h"

typedef struct fmb_sieve {
    fmb_run *run;
    size_t n, m;
    const fmb_lp_row *row;
    fmb_polar polar;
    fmb_gauge gauge; /* of rows known to be irredundant, some of them if there are many */
    fmb_combination combination;
    fmb_fate *fate;           /* [m] the caller's */
    const fmb_verdicts *told; /* the caller's, or NULL */
    size_t known, capacity;   /* rows known to be irredundant */
    size_t *name;             /* [capacity] the rows */
    double *at;               /* [d][capacity] their polar points, in round coordinates */
    double *score;            /* [capacity] scratch */
    bool *awake;              /* [m] in the gauge */
    double *target;           /* [d] the row at hand */
    size_t *support;          /* [d] scratch */
    mpq_t *x;                 /* [n] scratch */
} fmb_sieve;

/* row must outlive s. *inner: there is a point strictly inside, proved; else there may be one
 * (equalities leave none). Errors: MEMORY, LIMIT. In any case fmb_sieve_close it. */
fmb_status fmb_sieve_open(fmb_sieve *s, fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                          bool *inner);
void fmb_sieve_close(fmb_sieve *s);
/* With a point inside: fate[m], UNKNOWN on entry, becomes KEPT or REDUNDANT; a few rows may stay
 * UNKNOWN. told may be NULL. On LIMIT the fates set so far hold. Errors: MEMORY, LIMIT. */
fmb_status fmb_sieve_sort(fmb_sieve *s, fmb_fate *fate, const fmb_verdicts *told);

#endif
