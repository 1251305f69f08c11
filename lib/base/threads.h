/* threads.h: threads that stay for many rounds of jobs.
 *
 * The caller works as well, as thread 0. Between rounds the others sleep: to wait awake costs more
 * than it gains where rounds are short and the processor has other things to do. Jobs are taken in
 * the order of their numbers, so what must happen in that order can wait for its turn.
 *
 * Invariants: jobs below `next` are taken, `done` of them are over, those below `turn` have had
 * their turn. A crowd of threads must not move.
 */
#ifndef FMB_BASE_THREADS_H
#define FMB_BASE_THREADS_H

#include <pthread.h>

#include "base/mem.h"

/* Does job k, in thread `thread`. */
typedef void (*fmb_thread_job)(void *self, size_t k, size_t thread);

typedef struct fmb_threads {
    fmb_mem *mem;
    pthread_t *thread;                 /* [room] besides the caller's */
    size_t size, room;                 /* the system may grant fewer than asked for */
    pthread_mutex_t lock;              /* for all below */
    pthread_cond_t work, idle, turned; /* there is a job; all are done; another turn */
    fmb_thread_job job;
    void *self;
    size_t jobs, next, done, turn;
    size_t begun; /* threads that have taken their number */
    bool over;
} fmb_threads;

/* So many threads with the caller's, if the system grants them. Errors: MEMORY, LIMIT. In any case
 * fmb_threads_close it; a zeroed one may be closed as well. */
fmb_status fmb_threads_open(fmb_threads *t, fmb_mem *mem, size_t wanted);
/* Jobs 0 to jobs - 1: the other threads begin with them; the caller may do something else before it
 * joins them, until all are done. */
void fmb_threads_start(fmb_threads *t, size_t jobs, fmb_thread_job job, void *self);
void fmb_threads_finish(fmb_threads *t);
static inline void fmb_threads_do(fmb_threads *t, size_t jobs, fmb_thread_job job, void *self)
{
    fmb_threads_start(t, jobs, job, self);
    fmb_threads_finish(t);
}
/* In job k: wait until all jobs before it have ended their turn; then end that of k. Each job does
 * both, or none does. */
void fmb_threads_begin_turn(fmb_threads *t, size_t k);
void fmb_threads_end_turn(fmb_threads *t);
void fmb_threads_close(fmb_threads *t);

#endif
