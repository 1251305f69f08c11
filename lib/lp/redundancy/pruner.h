/* pruner.h: the state of the tests for redundancy, private to irredundant.c and its parts.
 *
 * Two oracles: one over all rows not yet removed, and one over the equalities alone.
 */
#ifndef FMB_LP_PRUNER_H
#define FMB_LP_PRUNER_H

#include <fmb/solve.h>

#include "lp/model/row.h"
#include "lp/oracle/oracle.h"
#include "lp/redundancy/verdicts.h"
#include "num/integers.h"

struct fmb_pruner {
    fmb_run *run;
    size_t n, m;
    const fmb_lp_row *row;
    fmb_fate *fate;
    const fmb_verdicts *told;
    bool as_given; /* no inequality becomes an equality */
    bool pauses;   /* may stop where a slice of the run is over */
    size_t left;   /* inequalities 0, ..., left - 1 are not yet tested */
    bool any_strict;
    bool *feasible;
    fmb_program all, equal; /* every row, removed ones switched off; independent equalities */
    fmb_oracle *over_all, *over_equal;
    size_t *equality;   /* [m] rows of `equal` */
    size_t *term;       /* [m] scratch: 1 + which term of a conflict a row is, or 0 */
    bool *is_nonzero;   /* [n] columns that some equality names */
    fmb_integers point; /* [n], over den: the last point of the oracle */
    mpz_t den, sum;
    mpq_t *inner, *x;    /* [n] a solution; scratch: a point to report */
    fmb_weights form, w; /* scratch */
};

/* Open the oracles and allocate the members after `feasible`; those before it are the caller's.
 * The caller must call fmb_pruner_clear even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_pruner_open(fmb_pruner *p);
void fmb_pruner_clear(fmb_pruner *p);

/* form = a_i. */
fmb_status fmb_pruner_write_form(fmb_pruner *p, size_t i);
/* Switch row i of the oracle over all rows off, or on again. */
void fmb_pruner_leave_out(fmb_pruner *p, size_t i);
void fmb_pruner_take_in(fmb_pruner *p, size_t i);
/* Row i is redundant, by the multipliers of the last optimum of o; row k of o is place[k], or k. */
fmb_status fmb_pruner_drop(fmb_pruner *p, const fmb_oracle *o, size_t i, const size_t *place);

#endif
