/* equations.h: a few linear equations, solved in whole numbers. */
#ifndef FMB_STUDY_EQUATIONS_H
#define FMB_STUDY_EQUATIONS_H

#include <fmb/gmp.h>

#include "study/draw/pairs.h"

enum { STUDY_EQUATIONS_MOST = STUDY_PAIR_MOST_DIM + 2 };

typedef struct study_equations {
    int n;
    mpz_t a[STUDY_EQUATIONS_MOST][STUDY_EQUATIONS_MOST]; /* coefficients, then their factors */
    mpz_t x[STUDY_EQUATIONS_MOST], divisor; /* right sides; then the solution is x / divisor */
    mpz_t turned[STUDY_EQUATIONS_MOST];
    int row[STUDY_EQUATIONS_MOST]; /* where the row of each place was */
    mp_bitcnt_t row_down[STUDY_EQUATIONS_MOST], column_down[STUDY_EQUATIONS_MOST];
} study_equations;

void study_equations_init(study_equations *e);
void study_equations_clear(study_equations *e);
/* Prepare for equations with those coefficients a[i][j], 0 <= i, j < n; false if these are
 * dependent. */
bool study_equations_factor(study_equations *e, int n);
/* x / divisor solves a[i][0] x_0 + ... + a[i][n - 1] x_{n-1} = what x[i] was, divisor > 0. */
void study_equations_solve(study_equations *e);
/* The same of a[0][j] x_0 + ... + a[n - 1][j] x_{n-1} = what x[j] was. */
void study_equations_solve_transposed(study_equations *e);

#endif
