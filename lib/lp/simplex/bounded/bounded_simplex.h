/* bounded_simplex.h: the simplex method in doubles for bounded unknowns, few and dense (basis.h),
 * of pairs and of active sets: guesses. */
#ifndef FMB_LP_BOUNDED_SIMPLEX_H
#define FMB_LP_BOUNDED_SIMPLEX_H

#include "lp/simplex/bounded/basis.h"
#include "trace/run.h"

typedef enum fmb_guess { FMB_GUESS_NONE = 0, FMB_GUESS_INSIDE, FMB_GUESS_OUTSIDE } fmb_guess;

/* Do unknowns within their ranges make up the target, with that of column `banned` 0 (SIZE_MAX: no
 * column)? INSIDE: basic columns have `value`, the others are at a bound. OUTSIDE: `normal`
 * separates them; if no range has an upper bound it is >= 0 on all columns, < 0 on the target. run
 * may be NULL. Errors: LIMIT. */
fmb_status fmb_simplex_search(fmb_basis *b, const double *target, size_t banned, fmb_run *run,
                              fmb_guess *out);

/* After a search ended INSIDE: maximize cost z; y[d] are the prices of the rows. False: not
 * reached. */
bool fmb_simplex_maximize(fmb_basis *b, const double *target, const double *cost, double *y);

#endif
