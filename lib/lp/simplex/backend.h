/* backend.h: the revised simplex method in doubles. It hands out a basis, and says nothing that
 * is believed.
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
    FMB_HINT_NONE = 0,   /* it gave up: the basis is where it stood */
    FMB_HINT_OPTIMUM,    /* of a search: a vertex */
    FMB_HINT_INFEASIBLE, /* row `odd` cannot hold beside the basis */
    FMB_HINT_UNBOUNDED   /* leaving the row at place `odd` of the basis goes on for ever */
} fmb_hint_kind;

typedef struct fmb_hint {
    fmb_hint_kind kind;
    size_t *basis; /* [n], the caller's */
    size_t odd;    /* INFEASIBLE: a row of the program; UNBOUNDED: a place of the basis */
} fmb_hint;

/* p must outlive the backend; its rows that are off are left out. Errors: MEMORY, LIMIT. */
fmb_status fmb_backend_open(fmb_run *run, const fmb_program *p, fmb_backend **out);
/* The same, perhaps with factors of the basis however few columns there are, for tests. */
fmb_status fmb_backend_open_with(fmb_run *run, const fmb_program *p, bool factors,
                                 fmb_backend **out);
void fmb_backend_close(fmb_backend *d);

/* Is there a solution? From where the last call ended. lean[n]: rather one where lean.x is large,
 * as large as may be where that does not take long; NULL: any. Errors: MEMORY, LIMIT. */
fmb_status fmb_backend_search(fmb_backend *d, const double *lean, fmb_hint *h);
/* Where is cost.x greatest, cost[n]? From where the last call ended; INFEASIBLE is possible. */
fmb_status fmb_backend_maximize(fmb_backend *d, const double *cost, fmb_hint *h);

/* Take in rows that were appended to the program. Errors: MEMORY, LIMIT. */
fmb_status fmb_backend_grow(fmb_backend *d);
/* Leave out row i, or (on) take it in again. */
void fmb_backend_switch(fmb_backend *d, size_t i, bool on);
/* Start from this basis[n] next time. */
void fmb_backend_place(fmb_backend *d, const size_t *basis);
/* Right sides by other numbers, right[m]; NULL: those of the program. For iterative refinement
 * (Gleixner, Steffy, Wolter 2016). */
void fmb_backend_shift(fmb_backend *d, const double *right);
/* Likewise, right sides of inequalities less by `by` times the sizes of a row's coefficients, as
 * rows and columns are scaled; until the next shift. */
void fmb_backend_move_in(fmb_backend *d, double by);
/* exponent[m]: 2 to the power of that is the size of row i, as rows and columns are scaled; 0 of
 * all rows where columns are not. */
void fmb_backend_sizes(const fmb_backend *d, int *exponent);
/* The right side of row i has changed in the program, and no other. */
void fmb_backend_shift_row(fmb_backend *d, size_t i);
/* x[n] / den: where the last question ended, rounded to multiples of 2^-fine, as columns are
 * scaled. False: it is beyond doubles. */
bool fmb_backend_point(fmb_backend *d, int fine, mpz_t *x, mpz_t den);
/* Tolerances as tight as they go, from now on. */
void fmb_backend_sharpen(fmb_backend *d);

#endif
