/* simplex.h: the simplex method in doubles, on a basis with bounds (basis.h). Guesses. */
#ifndef FMB_LP_SIMPLEX_H
#define FMB_LP_SIMPLEX_H

#include "lp/simplex/basis.h"
#include "trace/run.h"

typedef enum fmb_guess {
    FMB_GUESS_NONE = 0,
    FMB_GUESS_INSIDE,
    FMB_GUESS_OUTSIDE,
    FMB_GUESS_EXPENSIVE
} fmb_guess;

/* Do unknowns within their ranges make up the target, that of column `banned` at 0 (SIZE_MAX: none
 * is)? INSIDE: basic columns have `value`, the others are at an end. OUTSIDE: `normal` tells them
 * apart; if no range has an upper end it is >= 0 on all columns, < 0 on the target. run may be
 * NULL. Where there is a cost, no gain comes in positive, nor is one in the end, so that the cost
 * INSIDE is the greatest; or EXPENSIVE: it is less than enough. Errors: LIMIT. */
fmb_status fmb_simplex_search(fmb_basis *b, const double *target, size_t banned, fmb_run *run,
                              fmb_guess *out);

/* From where a search ended INSIDE to where cost z is greatest; y[d] are the prices of the rows.
 * False if that was not reached. */
bool fmb_simplex_maximize(fmb_basis *b, const double *target, const double *cost, double *y);

/* The prices of the rows, y[d]: the costs of the basic columns times the inverse. */
void fmb_simplex_find_prices(fmb_basis *b, const double *cost, double *y);
/* Gains and lengths of edges by the basis as it is, for a search with a cost. */
void fmb_simplex_measure(fmb_basis *b);

#endif
