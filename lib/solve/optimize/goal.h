/* goal.h: the objective of an optimization query as a dense vector, always to be maximized: a form
 * to be minimized is negated.
 */
#ifndef FMB_SOLVE_GOAL_H
#define FMB_SOLVE_GOAL_H

#include "solve/query/solver.h"

/* Where the objective comes from: one of these, or with both NULL the system's own. */
typedef struct fmb_wish {
    const fmb_objective *doubles;
    const fmb_objective_q *rationals;
} fmb_wish;

fmb_sense fmb_wish_sense(const fmb_system *s, fmb_wish wish);

typedef struct fmb_goal {
    fmb_sense sense;
    size_t dim;
    mpq_t *coef; /* [dim] of the maximized form: the objective, negated if it is minimized */
    mpq_t constant;
} fmb_goal;

/* Is that an objective over the variables of s? Errors: ARG. */
fmb_status fmb_goal_expect(fmb_solver *v, const fmb_system *s, fmb_wish wish);
/* fmb_goal_clear it, even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_goal_init(fmb_goal *g, const fmb_system *s, fmb_wish wish, fmb_mem *mem);
void fmb_goal_clear(fmb_goal *g, fmb_mem *mem);

/* Does the goal name one of the variables var[0..n)? */
bool fmb_goal_names(const fmb_goal *g, const int *var, int n);

static inline fmb_side fmb_goal_side(const fmb_goal *g)
{
    return g->sense == FMB_SENSE_MAX ? FMB_UPPER : FMB_LOWER;
}

#endif
