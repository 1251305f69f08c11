/* threads.h: a pool of threads for many rounds of jobs.
 *
 * The caller works as well, as thread 0. Between rounds the other threads sleep: busy waiting costs
 * more than it gains where rounds are short and the processor has other work. Jobs are taken in the
 * order of their numbers, so steps that must happen in that order can wait for their turn.
 *
 * Invariants: jobs below `next` are taken, `done` of them are finished, those below `turn` have had
 * their turn. The structure must not move while it is open.
 */
#ifndef FMB_BASE_THREADS_H
#define FMB_BASE_THREADS_H

#include <pthread.h>

#include "base/mem.h"

/* Does job k, in thread `thread`. */
typedef void (*fmb_thread_job)(void *self, size_t k, size_t thread);

typedef struct fmb_threads {
    fmb_mem *mem;
    pthread_t *thread;                 /* [room] without the caller */
    size_t size, room;                 /* the system may grant fewer than wanted */
    pthread_mutex_t lock;              /* for all below */
    pthread_cond_t work, idle, turned; /* new jobs; all jobs done; next turn */
    fmb_thread_job job;
    void *self;
    size_t jobs, next, done, turn;
    size_t begun; /* threads that have started, to number them */
    bool over;
} fmb_threads;

/* `wanted` threads with the caller, or fewer if the system refuses. Errors: MEMORY, LIMIT. The
 * caller must call fmb_threads_close even after an error; closing a zeroed structure is fine. */
fmb_status fmb_threads_open(fmb_threads *t, fmb_mem *mem, size_t wanted);
/* Jobs 0 to jobs - 1. After _start the other threads begin them while the caller may do something
 * else; in _finish the caller joins in, until all jobs are done. */
void fmb_threads_start(fmb_threads *t, size_t jobs, fmb_thread_job job, void *self);
void fmb_threads_finish(fmb_threads *t);
static inline void fmb_threads_do(fmb_threads *t, size_t jobs, fmb_thread_job job, void *self)
{
    fmb_threads_start(t, jobs, job, self);
    fmb_threads_finish(t);
}
/* Within job k: wait until all earlier jobs have ended their turn; then end the turn of job k.
 * Either all jobs of a round do both, or none does. */
void fmb_threads_begin_turn(fmb_threads *t, size_t k);
void fmb_threads_end_turn(fmb_threads *t);
void fmb_threads_close(fmb_threads *t);

#endif
