/* oracle.h: linear programs, guessed in doubles and certified exactly.
 *
 * The backend (lp/simplex/backend.h) guesses a basis; its vertex, multipliers or ray are computed
 * exactly (lp/linalg/exact/factor.h), and every row is checked. From a guess that is not quite
 * right exact pivots continue, or it is refined; Bland's rule makes every walk finite. Every answer
 * holds exactly.
 *
 * Sources: Applegate, Cook, Dash, Espinoza 2007, Exact solutions to linear programming problems;
 * Gleixner, Steffy, Wolter 2016, Iterative refinement for linear programming.
 */
#ifndef FMB_LP_ORACLE_H
#define FMB_LP_ORACLE_H

#include "lp/model/program.h"
#include "num/weights.h"
#include "trace/run.h"

typedef struct fmb_oracle fmb_oracle;

typedef enum fmb_oracle_end { FMB_ORACLE_OPTIMUM = 0, FMB_ORACLE_UNBOUNDED } fmb_oracle_end;

/* p must outlive the oracle. Errors: MEMORY, LIMIT. */
fmb_status fmb_oracle_new(fmb_run *run, const fmb_program *p, fmb_oracle **out);
void fmb_oracle_free(fmb_oracle *o);

/* Is there a solution? If so fmb_oracle_point reads it, else fmb_oracle_conflict gives a proof. */
fmb_status fmb_oracle_feasible(fmb_oracle *o, bool *feasible);
/* Let the next search for a solution prefer large cost.x, since that will be maximized. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_oracle_lean(fmb_oracle *o, const fmb_weights *cost);
/* tight: each solution to be found lies on some row. Then no interior solution is looked for. */
void fmb_oracle_expect_tight_rows(fmb_oracle *o, bool tight);
/* Has a solution been found since rows changed? */
bool fmb_oracle_has_solution(const fmb_oracle *o);

/* For a feasible program: the largest cost.x, cost over columns. Strict rows count as their
 * closures; *attained: some solution, strict rows included, reaches the optimum. */
fmb_status fmb_oracle_maximize(fmb_oracle *o, const fmb_weights *cost, fmb_oracle_end *end,
                               bool *attained);

/* The same in three steps, the last two optional. _approach: to a vertex where cost.x is large, the
 * optimum by the guess; *end is OPTIMUM if nothing is proved, UNBOUNDED if that is certain. _climb:
 * from there to the optimum of the closure. _attain: is it attained? The point may change then. */
fmb_status fmb_oracle_approach(fmb_oracle *o, const fmb_weights *cost, fmb_oracle_end *end);
fmb_status fmb_oracle_climb(fmb_oracle *o, fmb_oracle_end *end);
fmb_status fmb_oracle_attain(fmb_oracle *o, bool *attained);

/* After rows were appended, row i was switched off or on, or rows got other right sides: then
 * fmb_oracle_feasible must be called first. */
fmb_status fmb_oracle_grow(fmb_oracle *o);
void fmb_oracle_shift(fmb_oracle *o);
/* Like fmb_oracle_shift if only row i has another right side. */
void fmb_oracle_shift_row(fmb_oracle *o, size_t i);
void fmb_oracle_switch(fmb_oracle *o, size_t i, bool on);

/* After a limit has ended one of these: x[n] becomes the best point on the way; false if that does
 * not satisfy strict rows strictly, or if no solution was known. */
bool fmb_oracle_reached(fmb_oracle *o, mpq_t *x);

/* ---- answers: valid until the next call ------------------------------------------------------ */
/* Errors: LIMIT, where numbers are long (num/gcd.h). */

/* x[n]: the solution; after an optimum, one that reaches it, or if none does, one of the closure.
 */
fmb_status fmb_oracle_point(const fmb_oracle *o, mpq_t *x);
/* The same as integers x[n] over *den > 0. */
void fmb_oracle_point_integers(const fmb_oracle *o, mpz_t *x, mpz_t den);
fmb_status fmb_oracle_value(const fmb_oracle *o, mpq_t value);
/* Multipliers of rows: they combine to cost.x <= value, with < if it is not attained. */
fmb_status fmb_oracle_multipliers(const fmb_oracle *o, fmb_weights *w);
/* Multipliers that combine the rows to 0 <= b, b < 0, or to 0 < 0. */
fmb_status fmb_oracle_conflict(fmb_oracle *o, fmb_weights *w);
/* A direction of the recession cone in which cost.x grows. */
fmb_status fmb_oracle_ray(const fmb_oracle *o, mpq_t *x);
void fmb_oracle_ray_integers(const fmb_oracle *o, mpz_t *x);

#endif
