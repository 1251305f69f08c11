/* team.h: shares of a query that several threads work on, in many rounds of jobs.
 *
 * Job k always works with share k, whichever thread does it: so results depend neither on the
 * number of threads nor on their speed.
 *
 * Invariant: between rounds the memory of the shares is charged to the query's. The structure must
 * not move while it is open.
 */
#ifndef FMB_TRACE_TEAM_H
#define FMB_TRACE_TEAM_H

#include "base/threads.h"
#include "trace/run.h"

/* Does job k of a round; no other job uses the share meanwhile. */
typedef fmb_status (*fmb_team_job)(void *self, size_t k, fmb_run *share);

typedef struct fmb_team {
    fmb_run *run;
    fmb_share *share;  /* [size] */
    size_t size, held; /* held: charged [bytes] */
    fmb_threads threads;
    fmb_team_job job; /* of this round, with its argument */
    void *self;
    size_t jobs, limit; /* jobs of the round; the query's memory limit [bytes] */
} fmb_team;

/* As many threads as run->threads, or fewer if the system refuses. Errors: MEMORY, LIMIT. The
 * caller must call fmb_team_close even after an error. */
fmb_status fmb_team_open(fmb_team *t, fmb_run *run, size_t size);
/* Jobs 0 to jobs - 1 < size. Between _start and _finish the caller may use the run and its data,
 * except data that the jobs read, and may not give it to others. _finish returns the first failure
 * in the order of jobs; errors come before limits. Errors: LIMIT, and those of jobs. */
void fmb_team_start(fmb_team *t, size_t jobs, fmb_team_job job, void *self);
fmb_status fmb_team_finish(fmb_team *t);
static inline fmb_status fmb_team_do(fmb_team *t, size_t jobs, fmb_team_job job, void *self)
{
    fmb_team_start(t, jobs, job, self);
    return fmb_team_finish(t);
}
/* `bytes` of the memory of share k belong to the query itself from now on. Only between rounds. */
void fmb_team_hand_over(fmb_team *t, size_t k, size_t bytes);
/* The shares must hold nothing any more. */
void fmb_team_close(fmb_team *t);

#endif
