/* reduced_part.h: a part of which what is cheap has been eliminated.
 *
 * Variables that stand in an equality, or that make no more rows than go, are gone: all ways of a
 * projection begin there.
 */
#ifndef FMB_SOLVE_REDUCED_PART_H
#define FMB_SOLVE_REDUCED_PART_H

#include "elim/round/elim.h"
#include "solve/query/solver.h"

/* Whoever goes on with the elimination comes back to where it was (elim/round/mark.h). */
typedef struct fmb_reduced_part {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for variables that go */
    fmb_elim e;
    bool *drop; /* [n] variables that go */
    bool rest;  /* some of them are left in live rows */
} fmb_reduced_part;

/* *feasible false: its rows contradict each other. In any case fmb_reduced_part_close it. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_reduced_part_open(fmb_reduced_part *h, fmb_query *q, int part, const int *place,
                                 bool *feasible);
void fmb_reduced_part_close(fmb_reduced_part *h);

#endif
