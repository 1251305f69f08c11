/* factor.h: square sparse matrices of integers, solved exactly.
 *
 * B is made of n rows: row number basis[r] of a program, or where basis[r] = m + j the unit vector
 * e_j. It is factored once, sparse, modulo a prime p of a word, which tells its rank and the order
 * of its pivots. Where that order makes it triangular, it is solved by substitution; where it is
 * small, by its minors; else a solution is lifted to powers of p, digit by digit, until rational
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

/* p must outlive the factor, which sees rows that are appended later; rows of the basis stay in it
 * until the next basis is set. Errors: MEMORY, LIMIT. */
fmb_status fmb_factor_new(fmb_run *run, const fmb_program *p, fmb_factor **out);
void fmb_factor_free(fmb_factor *f);

/* Factor the matrix of these rows, basis[n]. Where it is singular (modulo the prime, which a second
 * prime confirms), rows that depend on others are exchanged for unit vectors of columns that would
 * be left over, in basis itself; *changed tells. Errors: MEMORY, LIMIT. */
fmb_status fmb_factor_set(fmb_factor *f, size_t *basis, bool *changed);

/* x[n] and *den > 0, in lowest terms together: B (x / den) = right. Exact, or an error: MEMORY,
 * LIMIT. right[n] is by place of the basis; sparse ones cost less. */
fmb_status fmb_factor_solve(fmb_factor *f, mpz_t *right, mpz_t *x, mpz_t den);
/* y[n], by place, and *den > 0: B^T (y / den) = cost, cost[n] by column. */
fmb_status fmb_factor_solve_transposed(fmb_factor *f, mpz_t *cost, mpz_t *y, mpz_t den);

#endif
