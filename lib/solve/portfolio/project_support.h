/* project_support.h: the projection of a part as the hull of what support queries find, without
 * eliminating anything; in turns, if need be.
 */
#ifndef FMB_SOLVE_PROJECT_SUPPORT_H
#define FMB_SOLVE_PROJECT_SUPPORT_H

#include "solve/query/solver.h"

typedef struct fmb_queries fmb_queries;

/* On those of the part's variables with place[] >= 0, perhaps none; place outlives it. *feasible
 * false: the part has no solution, and nothing can be asked. apart: with a share of the query, and
 * an oracle, of its own, so that another thread may ask. In any case fmb_queries_close what is not
 * NULL. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_queries_open(fmb_query *q, int part, const int *place, bool apart, fmb_queries **out,
                            bool *feasible);
/* The share, or NULL: its work is counted apart. */
fmb_share *fmb_queries_share(fmb_queries *h);
/* At a limit that something else has come to: ask on, for the time that was kept or a few queries,
 * unless it is a cancel; and put out what is proved, with points as claims. Errors: MEMORY. Then
 * close it. */
fmb_status fmb_queries_finish(fmb_queries *h, fmb_system *out);
void fmb_queries_close(fmb_queries *h);

/* Go on until a slice is over. *ready: the projection is known. */
fmb_status fmb_queries_run(fmb_queries *h, bool *ready);
/* Append it to out; or, after LIMIT, which is returned again, the rows that are proved. */
fmb_status fmb_queries_put(fmb_queries *h, fmb_system *out, fmb_status st);

/* The same by queries of its own, after a limit that came before any; *out may stay as it is.
 * Errors: MEMORY. */
fmb_status fmb_queries_at_limit(fmb_query *q, int part, const int *place, fmb_system *out);

/* All at once. */
fmb_status fmb_query_support_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible);

#endif
