/* oracle.h: linear programs, guessed in doubles and certified exactly.
 *
 * The backend (lp/simplex/backend.h) guesses a basis; its vertex, multipliers or ray are solved for
 * exactly (lp/linalg/exact/factor.h), and every row is checked. A guess that is not quite right is
 * walked on from by exact pivots, or refined; Bland's rule ends every walk. Nothing is answered
 * that does not hold exactly.
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

/* Is there a solution? If so fmb_oracle_point reads it, else fmb_oracle_conflict says why not. */
fmb_status fmb_oracle_feasible(fmb_oracle *o, bool *feasible);
/* The next search for a solution goes where cost.x is large, as somebody is going to maximize it.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_oracle_lean(fmb_oracle *o, const fmb_weights *cost);
/* Does each solution that will be asked for lie on some row? Then none is looked for inside. */
void fmb_oracle_expect_tight_rows(fmb_oracle *o, bool tight);
/* Has a solution been found since rows changed? */
bool fmb_oracle_has_solution(const fmb_oracle *o);

/* From a feasible program: how large can cost.x become, cost over columns? Of rows that are strict
 * the closure counts; *attained tells whether a solution reaches the optimum. */
fmb_status fmb_oracle_maximize(fmb_oracle *o, const fmb_weights *cost, fmb_oracle_end *end,
                               bool *attained);

/* The same in three steps, the last two for whoever needs them. To a vertex where cost.x is large,
 * as the guess has it; or OPTIMUM is not said, but UNBOUNDED, for sure. From there to the optimum
 * of the closure. Is that attained? Then the point may be another one. */
fmb_status fmb_oracle_approach(fmb_oracle *o, const fmb_weights *cost, fmb_oracle_end *end);
fmb_status fmb_oracle_climb(fmb_oracle *o, fmb_oracle_end *end);
fmb_status fmb_oracle_attain(fmb_oracle *o, bool *attained);

/* Rows were appended, row i was left out or taken in again, or rows have other right sides: ask
 * fmb_oracle_feasible first. */
fmb_status fmb_oracle_grow(fmb_oracle *o);
void fmb_oracle_shift(fmb_oracle *o);
/* The same of row i alone. */
void fmb_oracle_shift_row(fmb_oracle *o, size_t i);
void fmb_oracle_switch(fmb_oracle *o, size_t i, bool on);

/* A limit has ended one of these: x[n] becomes the best of the points on the way, unless that is
 * not strictly inside strict rows, or no solution was known: then false. */
bool fmb_oracle_reached(fmb_oracle *o, mpq_t *x);

/* ---- answers: valid until the next call ------------------------------------------------------ */
/* Errors: LIMIT, as far as numbers are long (num/gcd.h). */

/* x[n]: the solution; after an optimum, one that reaches it, or if none does, one of the closure.
 */
fmb_status fmb_oracle_point(const fmb_oracle *o, mpq_t *x);
/* The same in integers, over *den > 0. */
void fmb_oracle_point_integers(const fmb_oracle *o, mpz_t *x, mpz_t den);
fmb_status fmb_oracle_value(const fmb_oracle *o, mpq_t value);
/* Multipliers over rows: their combination is cost.x <= value, with < if it is not attained. */
fmb_status fmb_oracle_multipliers(const fmb_oracle *o, fmb_weights *w);
/* Their combination is 0 <= negative, or 0 < 0. */
fmb_status fmb_oracle_conflict(fmb_oracle *o, fmb_weights *w);
/* A direction in which every solution goes on for ever, and cost.x grows. */
fmb_status fmb_oracle_ray(const fmb_oracle *o, mpq_t *x);
void fmb_oracle_ray_integers(const fmb_oracle *o, mpz_t *x);

#endif
