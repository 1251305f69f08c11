/* objective_column.h: a part with one column more, z, which is the goal over its variables: the
 * rows of the part, then the row z = goal. So whatever is asked of the goal is asked of a variable.
 */
#ifndef FMB_SOLVE_OBJECTIVE_COLUMN_H
#define FMB_SOLVE_OBJECTIVE_COLUMN_H

#include "solve/optimize/goal.h"

/* In the arena but for wide entries. z is column p.n - 1, and no variable of the system (var -1);
 * row p.m - 1 is no row of it, and says that its source is that of row 0. */
typedef struct fmb_objective_column {
    fmb_part p;
    fmb_mem *mem;
} fmb_objective_column;

/* Errors: MEMORY, LIMIT. In any case fmb_objective_column_clear it. */
fmb_status fmb_objective_column_init(fmb_objective_column *w, fmb_query *q, int part,
                                     const fmb_goal *g);
void fmb_objective_column_clear(fmb_objective_column *w);

#endif
