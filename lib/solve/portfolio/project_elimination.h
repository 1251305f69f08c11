/* project_elimination.h: one part on its way by elimination, and the rows that come of it. */
#ifndef FMB_SOLVE_PROJECT_ELIMINATION_H
#define FMB_SOLVE_PROJECT_ELIMINATION_H

#include "solve/query/solver.h"

typedef struct fmb_part_elimination {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for variables that go */
    fmb_system *out;
    fmb_elim e;
} fmb_part_elimination;

/* Many rows for their variables are mostly redundant: then the rule looks before the first pairs,
 * whose number is the square of theirs. Else it waits until rows have doubled. */
bool fmb_has_rows_in_plenty(const fmb_part *p);
/* The elimination ended, with a status: put out what is irredundant of its rows; or, at a limit,
 * what names kept variables only. */
fmb_status fmb_put_rows_of_elimination(fmb_part_elimination *h, fmb_elim *e, fmb_status st,
                                       bool known, bool *feasible, bool *done);
/* All of it, and put out; known: the part is known to be feasible. */
fmb_status fmb_project_by_elimination(fmb_part_elimination *h, bool known, bool *feasible,
                                      bool *done);

#endif
