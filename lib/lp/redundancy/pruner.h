/* pruner.h: rows of which some are decided, private to the tests for redundancy.
 *
 * Two oracles: one of all rows that have not gone, and one of the equalities alone.
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
    size_t left;   /* rows not yet looked at: the first ones */
    bool any_strict;
    bool *feasible;
    fmb_program all, equal; /* every row, those gone being off; the equalities that stay */
    fmb_oracle *over_all, *over_equal;
    size_t *equality;   /* [m] rows of `equal` */
    size_t *term;       /* [m] scratch: 1 + which term of a conflict a row is, or 0 */
    bool *is_nonzero;   /* [n] columns that some equality names */
    fmb_integers point; /* [n], over den: what the oracle said last */
    mpz_t den, sum;
    mpq_t *inner, *x;    /* [n] a solution; scratch: a point that is told */
    fmb_weights form, w; /* scratch */
};

/* Fill in what is behind `feasible`; rows that have gone are off. Errors: MEMORY, LIMIT. In any
 * case fmb_pruner_clear it. */
fmb_status fmb_pruner_open(fmb_pruner *p);
void fmb_pruner_clear(fmb_pruner *p);

/* form = a_i. */
fmb_status fmb_pruner_write_form(fmb_pruner *p, size_t i);
/* Row i does not count, or again. */
void fmb_pruner_leave_out(fmb_pruner *p, size_t i);
void fmb_pruner_take_in(fmb_pruner *p, size_t i);
/* Row i goes, with the multipliers of the last optimum; place numbers its rows, NULL: as here. */
fmb_status fmb_pruner_drop(fmb_pruner *p, const fmb_oracle *o, size_t i, const size_t *place);

#endif
