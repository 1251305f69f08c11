/* reduced_part.h: a part after its cheap eliminations, where all engines of a projection begin.
 *
 * Eliminated are the variables that occur in an equality, and those whose elimination adds no more
 * rows than it removes.
 */
#ifndef FMB_SOLVE_REDUCED_PART_H
#define FMB_SOLVE_REDUCED_PART_H

#include "elim/round/elim.h"
#include "solve/query/solver.h"

/* An engine that continues the elimination must restore this state (elim/round/mark.h). */
typedef struct fmb_reduced_part {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for variables to eliminate */
    fmb_elim e;
    bool *drop; /* [n] variables to eliminate */
    int kept;   /* the number of the others */
    bool rest;  /* live rows still name some of them */
} fmb_reduced_part;

/* *feasible false: its rows contradict each other. fmb_reduced_part_close it, even after an error.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_reduced_part_open(fmb_reduced_part *h, fmb_query *q, int part, const int *place,
                                 bool *feasible);
void fmb_reduced_part_close(fmb_reduced_part *h);

#endif
