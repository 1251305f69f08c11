/* pivot_walk.h: exact pivots from a basis to one that answers: the way on from a guess that is not
 * quite right. Each pivot is a factorisation and two or three solutions, so few are hoped for;
 * Bland's rule, after some patience, sees to it that there is an end.
 */
#ifndef FMB_LP_ORACLE_PIVOT_WALK_H
#define FMB_LP_ORACLE_PIVOT_WALK_H

#include "lp/oracle/vertex.h"

/* Why a walk to a feasible vertex ended. */
typedef enum fmb_pivot_walk_end {
    FMB_PIVOT_WALK_REACHED =
        0, /* the vertex satisfies all rows; or, of the other walk, is the optimum */
    FMB_PIVOT_WALK_CONFLICT,       /* row `odd`, times `sign`, contradicts the basis */
    FMB_PIVOT_WALK_RAY,            /* `ray` leads away for ever */
    FMB_PIVOT_WALK_ITERATION_LIMIT /* so many steps were not enough */
} fmb_pivot_walk_end;

typedef struct fmb_pivot_walk {
    fmb_vertex *v;
    fmb_integers cost; /* [n] scratch: what is priced */
    size_t odd;
    int sign;
    bool is_priced;                                /* y are the prices of row `odd`, times `sign` */
    fmb_integers ray;                              /* [n], over ray_den */
    mpz_t ray_den, ratio_num, ratio_den, num, den; /* the last four are scratch */
} fmb_pivot_walk;

/* Errors: MEMORY, LIMIT. In any case fmb_pivot_walk_clear it. */
fmb_status fmb_pivot_walk_init(fmb_pivot_walk *w, fmb_vertex *v);
void fmb_pivot_walk_clear(fmb_pivot_walk *w);

/* Is row `odd` in conflict with the basis at hand, as a guess has it? CONFLICT, or ITERATION_LIMIT.
 */
fmb_status fmb_pivot_walk_try_conflict(fmb_pivot_walk *w, size_t odd, fmb_pivot_walk_end *end);
/* Solve for the prices of row `odd`, times `sign`, unless that is done. Errors: MEMORY, LIMIT. */
fmb_status fmb_pivot_walk_price_conflict(fmb_pivot_walk *w);
/* Does leaving the row at place r lead away for ever, raising cost? RAY, or ITERATION_LIMIT. */
fmb_status fmb_pivot_walk_try_ray(fmb_pivot_walk *w, size_t r, mpz_t *cost,
                                  fmb_pivot_walk_end *end);

/* To a vertex that satisfies all rows, in at most so many steps (0: any number): REACHED, CONFLICT
 * or ITERATION_LIMIT. The dual simplex method without costs (Dutertre and de Moura 2006). */
fmb_status fmb_pivot_walk_to_feasible(fmb_pivot_walk *w, size_t steps, fmb_pivot_walk_end *end);
/* From there to where cost.x is greatest, in at most so many steps (0: any number): REACHED, RAY,
 * or ITERATION_LIMIT; then y are the prices at hand. */
fmb_status fmb_pivot_walk_to_optimum(fmb_pivot_walk *w, size_t steps, mpz_t *cost,
                                     fmb_pivot_walk_end *end);
/* Can the price of place r be had from a proof? Those of rows that nothing demands are 0, and
 * `sign` times those of inequalities are not negative. */
bool fmb_pivot_walk_is_price_allowed(const fmb_vertex *v, size_t r, int sign);

#endif
