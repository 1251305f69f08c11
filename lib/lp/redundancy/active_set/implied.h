/* implied.h: which rows the others imply, guessed in doubles and proved in integers. */
#ifndef FMB_LP_IMPLIED_H
#define FMB_LP_IMPLIED_H

#include "lp/model/row.h"
#include "trace/run.h"

/* What is found out about m rows. */
typedef struct fmb_sorting {
    bool *gone;       /* [m] in: false; out: inequalities that are implied by the rows not gone */
    bool *kept;       /* [m] in: known to be irredundant; out: proved to be so, too */
    bool wants_tight; /* in: rows that are always tight are told, where they are few */
    uint64_t tight;   /* out: bit i: inequality i is, where there is a solution; then nothing else
                         is told */
    bool known;       /* in: the rows are known to have a solution, or it does not matter */
    bool pauses; /* in: may end before all rows are looked at, where a slice of the run is over */
    struct fmb_paused_sorting
        *paused;     /* in: NULL at first; out: it did so, and nothing is told yet */
    bool feasible;   /* false if there is none, and nothing else was found out */
    bool inner;      /* some point is strictly inside all rows */
    size_t doubtful; /* rows that seemed to be implied, but whose multipliers were not found; of
                        numbers beyond 62 bits all that are undecided */
} fmb_sorting;

/* Sort out rows. Each that goes is proved by multipliers over rows that are still there; each that
 * is kept by a ray that leaves through it alone. Others stay undecided: all of them if some number
 * is beyond 62 bits, and no solution is known, nor one found strictly inside. Where it paused, the
 * next call with the same rows goes on from there. Errors: MEMORY, LIMIT; after which it is not
 * paused. */
fmb_status fmb_lp_sort_rows(fmb_run *run, int n, size_t m, const fmb_lp_row *row, fmb_sorting *out);
/* Give up where it paused, if it did. */
void fmb_lp_sorting_clear(fmb_sorting *s);

#endif
