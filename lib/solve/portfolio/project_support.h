/* project_support.h: the projection of a part as the hull of the points and directions that support
 * queries find, without elimination; it can be interrupted and continued in turns.
 */
#ifndef FMB_SOLVE_PROJECT_SUPPORT_H
#define FMB_SOLVE_PROJECT_SUPPORT_H

#include "solve/query/solver.h"

typedef struct fmb_queries fmb_queries;

/* The projection on the part's variables with place[] >= 0, perhaps none; place outlives *out.
 * *feasible false: the part has no solution, and there is nothing to query. apart: *out has its own
 * share of the query and its own oracle, so that another thread may run it. fmb_queries_close *out
 * unless it is NULL, even after an error. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_queries_open(fmb_query *q, int part, const int *place, bool apart, fmb_queries **out,
                            bool *feasible);
/* The share, if opened with `apart`, else NULL. Its work is counted separately. */
fmb_share *fmb_queries_share(fmb_queries *h);
/* After a limit that another engine has reached: unless it is a cancel, query for the reserved time
 * or a few more times; then append the proved rows to out, with points as claims. Close it then.
 * Errors: MEMORY. */
fmb_status fmb_queries_finish(fmb_queries *h, fmb_system *out);
void fmb_queries_close(fmb_queries *h);

/* Continue until the slice is used up. *ready: the projection is known. */
fmb_status fmb_queries_run(fmb_queries *h, bool *ready);
/* Append the projection to out; where st is LIMIT, the rows proved so far, and return LIMIT. */
fmb_status fmb_queries_put(fmb_queries *h, fmb_system *out, fmb_status st);

/* After a limit reached before any query: open, query and append as above; perhaps nothing is
 * appended. Errors: MEMORY. */
fmb_status fmb_queries_at_limit(fmb_query *q, int part, const int *place, fmb_system *out);

/* Open, run to the end, append and close. */
fmb_status fmb_query_support_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible);

#endif
