/* component_optimum.h: the optimum of a goal over one part, by one of several methods. */
#ifndef FMB_SOLVE_COMPONENT_OPTIMUM_H
#define FMB_SOLVE_COMPONENT_OPTIMUM_H

#include "solve/optimize/objective_column.h"

typedef struct fmb_component_optimum {
    fmb_end_kind kind; /* UNKNOWN: this method found nothing */
    bool attained;
    bool clash;    /* at a limit: the rows of the part contradict each other, and a claim says so */
    mpq_t value;   /* FINITE, OUTER: goal <= value over the part; < if it is not attained */
    fmb_weights w; /* multipliers of the part's rows that prove this */
    bool reached;  /* a limit ended the search, and x is the best solution found so far */
    mpq_t *x;      /* [room] FINITE: a point there, of the closure if it is not attained;
                      INFINITE: a ray. By column */
    size_t room;   /* one more than the columns of any part */
} fmb_component_optimum;

/* fmb_component_optimum_clear it, even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_component_optimum_init(fmb_component_optimum *k, fmb_query *q);
void fmb_component_optimum_clear(fmb_component_optimum *k, fmb_query *q);

/* Announce the goal to the oracle of the part, before it is queried. Errors: MEMORY, LIMIT. */
fmb_status fmb_component_optimum_lean(fmb_query *q, const fmb_goal *g, int part);

/* One method; what k held before is overwritten. FINITE and INFINITE are exact; OUTER is a bound
 * proved after a limit. */
typedef fmb_status fmb_component_optimum_method(fmb_query *q, const fmb_goal *g, int part,
                                                fmb_component_optimum *k);

/* By the oracle; by elimination of all columns but the goal; after a limit, by the ends of the
 * variables, which never returns LIMIT. All but the last need a part known to be feasible. */
fmb_component_optimum_method fmb_component_optimum_by_oracle, fmb_component_optimum_by_elimination,
    fmb_component_optimum_at_limit;

#endif
