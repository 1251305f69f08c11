/* team.h: shares of a query that stay for many rounds of jobs, by several threads.
 *
 * Job k always works with share k, whichever thread does it: so what is found does not depend on
 * how many threads there are, or on which of them was faster.
 *
 * Invariant: what the shares hold is charged to the query's memory between rounds. A team must not
 * move.
 */
#ifndef FMB_TRACE_TEAM_H
#define FMB_TRACE_TEAM_H

#include "base/threads.h"
#include "trace/run.h"

/* Does part k of a round; the share belongs to it alone. */
typedef fmb_status (*fmb_team_job)(void *self, size_t k, fmb_run *share);

typedef struct fmb_team {
    fmb_run *run;
    fmb_share *share;  /* [size] */
    size_t size, held; /* held: charged [bytes] */
    fmb_threads threads;
    fmb_team_job job; /* of this round, */
    void *self;
    size_t jobs, limit; /* so many; the query's limit of memory [bytes] */
} fmb_team;

/* As many threads as the run has, if the system grants them. Errors: MEMORY, LIMIT. In any case
 * fmb_team_close it. */
fmb_status fmb_team_open(fmb_team *t, fmb_run *run, size_t size);
/* Jobs 0 to jobs - 1 < size. In between the caller may do something else with the run, but for what
 * jobs look at, nor give it to others. What went wrong first, in order; anything before a limit.
 * Errors: LIMIT, and those of jobs. */
void fmb_team_start(fmb_team *t, size_t jobs, fmb_team_job job, void *self);
fmb_status fmb_team_finish(fmb_team *t);
static inline fmb_status fmb_team_do(fmb_team *t, size_t jobs, fmb_team_job job, void *self)
{
    fmb_team_start(t, jobs, job, self);
    return fmb_team_finish(t);
}
/* So many bytes of what share k holds are the query's own from now on. Between rounds. */
void fmb_team_hand_over(fmb_team *t, size_t k, size_t bytes);
/* The shares hold nothing any more. */
void fmb_team_close(fmb_team *t);

#endif
