/* pivot_walk.h: exact pivots from a guessed basis that is not quite right to one that answers. Each
 * pivot is a factorization and two or three solutions, so there should be few; after some steps
 * Bland's rule ensures that the walk ends.
 */
#ifndef FMB_LP_ORACLE_PIVOT_WALK_H
#define FMB_LP_ORACLE_PIVOT_WALK_H

#include "lp/oracle/vertex.h"

/* The end of a walk to a feasible or an optimal vertex. */
typedef enum fmb_pivot_walk_end {
    FMB_PIVOT_WALK_REACHED = 0, /* the vertex satisfies all rows; in the other walk: is optimal */
    FMB_PIVOT_WALK_CONFLICT,    /* row `odd`, times `sign`, contradicts the basis */
    FMB_PIVOT_WALK_RAY,         /* `ray` is an unbounded direction */
    FMB_PIVOT_WALK_ITERATION_LIMIT /* the number of steps did not suffice */
} fmb_pivot_walk_end;

typedef struct fmb_pivot_walk {
    fmb_vertex *v;
    fmb_integers cost; /* [n] scratch: the cost to price */
    size_t odd;
    int sign;
    bool is_priced;                                /* y are the prices of row `odd`, times `sign` */
    fmb_integers ray;                              /* [n], over ray_den */
    mpz_t ray_den, ratio_num, ratio_den, num, den; /* the last four are scratch */
} fmb_pivot_walk;

/* Errors: MEMORY, LIMIT. The caller must call fmb_pivot_walk_clear even after an error. */
fmb_status fmb_pivot_walk_init(fmb_pivot_walk *w, fmb_vertex *v);
void fmb_pivot_walk_clear(fmb_pivot_walk *w);

/* Does row `odd` contradict the current basis, as a guess has it? CONFLICT, or ITERATION_LIMIT.
 */
fmb_status fmb_pivot_walk_try_conflict(fmb_pivot_walk *w, size_t odd, fmb_pivot_walk_end *end);
/* Compute the prices of row `odd`, times `sign`, unless known. Errors: MEMORY, LIMIT. */
fmb_status fmb_pivot_walk_price_conflict(fmb_pivot_walk *w);
/* Is the edge leaving the row at place r unbounded, raising cost? RAY, or ITERATION_LIMIT. */
fmb_status fmb_pivot_walk_try_ray(fmb_pivot_walk *w, size_t r, mpz_t *cost,
                                  fmb_pivot_walk_end *end);

/* Walk to a vertex that satisfies all rows, in at most so many steps (0: any number): REACHED,
 * CONFLICT or ITERATION_LIMIT. Dual simplex method without costs (Dutertre and de Moura 2006). */
fmb_status fmb_pivot_walk_to_feasible(fmb_pivot_walk *w, size_t steps, fmb_pivot_walk_end *end);
/* From there, walk to the largest cost.x in at most so many steps (0: any number): REACHED, RAY, or
 * ITERATION_LIMIT; after that y are the current prices. */
fmb_status fmb_pivot_walk_to_optimum(fmb_pivot_walk *w, size_t steps, mpz_t *cost,
                                     fmb_pivot_walk_end *end);
/* Is the sign of the price of place r valid in a proof? Prices of unit vectors and of rows that are
 * off must be 0, and `sign` times those of inequalities must not be negative. */
bool fmb_pivot_walk_is_price_allowed(const fmb_vertex *v, size_t r, int sign);

#endif
