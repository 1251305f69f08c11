/* equations.h: a few linear equations, solved in whole numbers. */
#ifndef FMB_STUDY_EQUATIONS_H
#define FMB_STUDY_EQUATIONS_H

#include <fmb/gmp.h>

#include "study/draw/pairs.h"

enum { STUDY_EQUATIONS_MOST = STUDY_PAIR_MOST_DIM + 2 };

typedef struct study_equations {
    mpz_t a[STUDY_EQUATIONS_MOST][STUDY_EQUATIONS_MOST + 1]; /* coefficients, right side */
    mpz_t x[STUDY_EQUATIONS_MOST], divisor;                  /* the solution is x / divisor */
} study_equations;

void study_equations_init(study_equations *e);
void study_equations_clear(study_equations *e);
/* x / divisor solves the first n of a[i][0] x_0 + ... + a[i][n - 1] x_{n-1} = a[i][n], divisor > 0;
 * false if they are dependent. Their numbers do not last. */
bool study_equations_solve(study_equations *e, int n);

#endif
