/* backend.h: the revised simplex method in doubles. It returns a basis, as a guess to be verified.
 *
 * A basis is n rows that are to hold with equality: rows of the program, by number; or m + j, the
 * row x_j = 0 of a column that is free and nonbasic. A backend is used by one thread at a time.
 */
#ifndef FMB_LP_BACKEND_H
#define FMB_LP_BACKEND_H

#include "lp/model/program.h"
#include "trace/run.h"

typedef struct fmb_backend fmb_backend;

typedef enum fmb_hint_kind {
    FMB_HINT_NONE = 0,   /* it gave up: the basis is the last one */
    FMB_HINT_OPTIMUM,    /* after a search: a vertex */
    FMB_HINT_INFEASIBLE, /* row `odd` contradicts the basis */
    FMB_HINT_UNBOUNDED   /* the edge that leaves place `odd` of the basis is unbounded */
} fmb_hint_kind;

typedef struct fmb_hint {
    fmb_hint_kind kind;
    size_t *basis; /* [n], the caller's */
    size_t odd;    /* INFEASIBLE: a row of the program; UNBOUNDED: a place of the basis */
} fmb_hint;

/* p must outlive the backend; rows that are off are ignored. Errors: MEMORY, LIMIT. */
fmb_status fmb_backend_open(fmb_run *run, const fmb_program *p, fmb_backend **out);
/* The same, with an LU of the basis for any number of columns if `factors`, for tests. */
fmb_status fmb_backend_open_with(fmb_run *run, const fmb_program *p, bool factors,
                                 fmb_backend **out);
void fmb_backend_close(fmb_backend *d);

/* Search for a solution, starting where the last call ended. lean[n]: preferably with large lean.x,
 * even maximal if that is cheap; NULL: any. Errors: MEMORY, LIMIT. */
fmb_status fmb_backend_search(fmb_backend *d, const double *lean, fmb_hint *h);
/* Maximize cost.x, cost[n], starting where the last call ended; INFEASIBLE is possible. */
fmb_status fmb_backend_maximize(fmb_backend *d, const double *cost, fmb_hint *h);

/* Copy rows that were appended to the program. Errors: MEMORY, LIMIT. */
fmb_status fmb_backend_grow(fmb_backend *d);
/* Ignore row i, or (on) use it again. */
void fmb_backend_switch(fmb_backend *d, size_t i, bool on);
/* Start the next call from this basis[n]. */
void fmb_backend_place(fmb_backend *d, const size_t *basis);
/* Use the right sides right[m], of rows as they are in doubles (program.h); NULL: those of the
 * program. For iterative refinement (Gleixner, Steffy, Wolter 2016). */
void fmb_backend_shift(fmb_backend *d, const double *right);
/* Until the next shift: lower the right sides of inequalities by `by` times the sum of the sizes of
 * a row's scaled coefficients. */
void fmb_backend_move_in(fmb_backend *d, double by);
/* exponent[m]: 2^exponent[i] is the size of row i, as rows and columns are scaled; 0 for all rows
 * if columns are not scaled. */
void fmb_backend_sizes(const fmb_backend *d, int *exponent);
/* Only the right side of row i has changed in the program: copy it. */
void fmb_backend_shift_row(fmb_backend *d, size_t i);
/* x[n] / den: the point where the last query ended, rounded to multiples of 2^-fine in scaled
 * columns. False: it is beyond doubles. */
bool fmb_backend_point(fmb_backend *d, int fine, mpz_t *x, mpz_t den);
/* Use the tightest tolerances from now on. */
void fmb_backend_sharpen(fmb_backend *d);

#endif
