/* factor.h: square sparse matrices of integers, solved exactly.
 *
 * B consists of n rows: row basis[r] of a program, or the unit vector e_j if basis[r] = m + j. It
 * is factored once, sparse, modulo a prime p of one word, which gives its rank and the order of its
 * pivots. If that order makes it triangular, it is solved by substitution; if it is small, by its
 * minors; otherwise a solution is lifted to powers of p, digit by digit, until rational
 * reconstruction gives numbers that hold exactly.
 *
 * Sources: Dixon 1982, Exact solution of linear equations using p-adic expansions; Wan 2006, An
 * algorithm to solve integer linear systems exactly using numerical methods; Cook and Steffy 2011,
 * Solving very sparse rational systems of equations.
 */
#ifndef FMB_LP_FACTOR_H
#define FMB_LP_FACTOR_H

#include "lp/model/program.h"
#include "trace/run.h"

typedef struct fmb_factor fmb_factor;

/* p must outlive the factor, which sees rows appended later; a basis keeps its rows until the next
 * one is set. Errors: MEMORY, LIMIT. */
fmb_status fmb_factor_new(fmb_run *run, const fmb_program *p, fmb_factor **out);
void fmb_factor_free(fmb_factor *f);

/* Factor the matrix of the rows basis[n]. If it is singular (modulo the prime, confirmed by a
 * second prime), dependent rows are replaced in basis[] by unit vectors of the columns left over;
 * *changed: this happened. Errors: MEMORY, LIMIT. */
fmb_status fmb_factor_set(fmb_factor *f, size_t *basis, bool *changed);

/* x[n] and *den > 0, in lowest terms together: B (x / den) = right, exactly. right[n] is by place
 * of the basis; a sparse one costs less. Errors: MEMORY, LIMIT. */
fmb_status fmb_factor_solve(fmb_factor *f, mpz_t *right, mpz_t *x, mpz_t den);
/* y[n], by place, and *den > 0: B^T (y / den) = cost, cost[n] by column. */
fmb_status fmb_factor_solve_transposed(fmb_factor *f, mpz_t *cost, mpz_t *y, mpz_t den);

#endif
