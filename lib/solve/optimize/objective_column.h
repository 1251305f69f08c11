/* objective_column.h: a part with one additional column z for the objective: the rows of the part,
 * then the row z = goal. So bounds of the objective are bounds of a variable.
 */
#ifndef FMB_SOLVE_OBJECTIVE_COLUMN_H
#define FMB_SOLVE_OBJECTIVE_COLUMN_H

#include "solve/optimize/goal.h"

/* Wide entries are the only ones outside the arena. z is column p.n - 1, with var -1, as it is no
 * variable of the system; row p.m - 1 is no row of the system, and its source is that of row 0. */
typedef struct fmb_objective_column {
    fmb_part p;
    fmb_mem *mem;
} fmb_objective_column;

/* fmb_objective_column_clear it, even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_objective_column_init(fmb_objective_column *w, fmb_query *q, int part,
                                     const fmb_goal *g);
void fmb_objective_column_clear(fmb_objective_column *w);

#endif
