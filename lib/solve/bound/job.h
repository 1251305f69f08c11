/* job.h: what bounding variables by the oracle and bounding them by elimination share. */
#ifndef FMB_SOLVE_JOB_H
#define FMB_SOLVE_JOB_H

#include "solve/query/exact_intervals.h"
#include "solve/query/solver.h"

/* One end being worked on: variable, side, sign 1 for the upper end, and where the answer goes. */
typedef struct fmb_bound_job {
    fmb_query *q;
    const fmb_part *p; /* NULL: no row names the variable */
    int var, column;
    fmb_side side;
    int sign;
    fmb_exact_side *end;
} fmb_bound_job;

/* w, over the part's rows, proves the end; the query's x is a point at it. */
fmb_status fmb_bound_claim(fmb_bound_job *j, const fmb_weights *w);
/* The query's x is a ray of the part, or the variable is in no part. */
fmb_status fmb_bound_claim_unbounded(fmb_bound_job *j);

/* halving.c: all intervals of variables of the part, by elimination. */
fmb_status fmb_bound_by_elimination(fmb_query *q, int part, fmb_box *box);

#endif
