/* component_optimum.h: how far a goal goes over one part, in several ways. */
#ifndef FMB_SOLVE_COMPONENT_OPTIMUM_H
#define FMB_SOLVE_COMPONENT_OPTIMUM_H

#include "solve/optimize/objective_column.h"

typedef struct fmb_component_optimum {
    fmb_end_kind kind; /* UNKNOWN: the way did not lead anywhere */
    bool attained;
    bool clash;    /* at a limit: the rows of the part contradict each other, and a claim says so */
    mpq_t value;   /* FINITE, OUTER: goal <= value over the part; < if it is not attained */
    fmb_weights w; /* over the part's rows: they prove that */
    bool reached;  /* a limit came first, and x is the best solution on the way */
    mpq_t *x;      /* [room] FINITE: a point there, of the closure if it is not attained;
                      INFINITE: a ray. By column */
    size_t room;   /* one more than the columns of any part */
} fmb_component_optimum;

/* Errors: MEMORY, LIMIT. In any case fmb_component_optimum_clear it. */
fmb_status fmb_component_optimum_init(fmb_component_optimum *k, fmb_query *q);
void fmb_component_optimum_clear(fmb_component_optimum *k, fmb_query *q);

/* The oracle of the part is told that it will be asked for that. Errors: MEMORY, LIMIT. */
fmb_status fmb_component_optimum_lean(fmb_query *q, const fmb_goal *g, int part);

/* One way; what k held before is gone. FINITE and INFINITE are exact; OUTER is what a limit has
 * left. */
typedef fmb_status fmb_component_optimum_method(fmb_query *q, const fmb_goal *g, int part,
                                                fmb_component_optimum *k);

/* By the oracle; by elimination of all but the goal; and, when a limit was reached, by the ends of
 * variables, which never returns LIMIT. The part is known to be feasible but for the last one. */
fmb_component_optimum_method fmb_component_optimum_by_oracle, fmb_component_optimum_by_elimination,
    fmb_component_optimum_at_limit;

#endif
