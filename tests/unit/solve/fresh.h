/* fresh.h: queries about a solver's loaded system, answered by this solver and by a fresh one. */
#ifndef FMB_TEST_FRESH_H
#define FMB_TEST_FRESH_H

#include <fmb/gmp.h>

/* A solver that keeps all evidence. */
fmb_solver *open_solver(const fmb_alloc *mem);
/* The last query's evidence is accepted. */
void expect_proof(fmb_solver *v, const fmb_system *s);

/* VERDICT; and the box; and the optimum of x_1 + 2 x_2 + 3 x_3 + ... and its like. */
typedef enum questions { VERDICT, ALL_QUESTIONS } questions;

/* Both say the same, and prove it. */
fmb_verdict expect_as_fresh(fmb_solver *v, questions ask);

#endif
