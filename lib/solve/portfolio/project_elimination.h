/* project_elimination.h: the projection of one part by elimination. */
#ifndef FMB_SOLVE_PROJECT_ELIMINATION_H
#define FMB_SOLVE_PROJECT_ELIMINATION_H

#include "solve/query/solver.h"

typedef struct fmb_part_elimination {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for eliminated variables */
    fmb_system *out;
    fmb_elim e;
} fmb_part_elimination;

/* Has the part many rows for its variables? Most are redundant then, and the rule prunes before the
 * first, quadratically many pairs are formed. Else it waits until the rows have doubled. */
bool fmb_has_rows_in_plenty(const fmb_part *p);
/* The elimination e ended with status st: append its irredundant rows to h->out; after a limit, its
 * rows over kept variables only. */
fmb_status fmb_put_rows_of_elimination(fmb_part_elimination *h, fmb_elim *e, fmb_status st,
                                       bool known, bool *feasible, bool *done);
/* Eliminate all variables and append the rows; known: the part is known to be feasible. */
fmb_status fmb_project_by_elimination(fmb_part_elimination *h, bool known, bool *feasible,
                                      bool *done);

#endif
