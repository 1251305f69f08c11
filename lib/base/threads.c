/* threads.c: see threads.h. */
#include "base/threads.h"

/* Do jobs until none is left; the lock is held between jobs. */
static void do_jobs_of_round(fmb_threads *t, size_t thread)
{
    while (t->next < t->jobs) {
        size_t k = t->next++;
        pthread_mutex_unlock(&t->lock);
        t->job(t->self, k, thread);
        pthread_mutex_lock(&t->lock);
        if (++t->done == t->jobs)
            pthread_cond_signal(&t->idle);
    }
}

static void *work_for_rounds(void *threads)
{
    fmb_threads *t = threads;
    pthread_mutex_lock(&t->lock);
    size_t thread = ++t->begun;
    while (!t->over) {
        do_jobs_of_round(t, thread);
        if (!t->over)
            pthread_cond_wait(&t->work, &t->lock);
    }
    pthread_mutex_unlock(&t->lock);
    return NULL;
}

fmb_status fmb_threads_open(fmb_threads *t, fmb_mem *mem, size_t wanted)
{
    *t = (fmb_threads){.mem = mem};
    FMB_TRY(FMB_GET_ZERO(mem, t->thread, wanted));
    t->room = wanted;
    pthread_mutex_init(&t->lock, NULL);
    pthread_cond_init(&t->work, NULL);
    pthread_cond_init(&t->idle, NULL);
    pthread_cond_init(&t->turned, NULL);
    while (t->size + 1 < wanted &&
           pthread_create(&t->thread[t->size], NULL, work_for_rounds, t) == 0)
        t->size++;
    return FMB_OK;
}

void fmb_threads_close(fmb_threads *t)
{
    if (!t->thread)
        return;
    pthread_mutex_lock(&t->lock);
    t->over = true;
    pthread_cond_broadcast(&t->work);
    pthread_mutex_unlock(&t->lock);
    for (size_t k = 0; k < t->size; k++)
        pthread_join(t->thread[k], NULL);
    pthread_mutex_destroy(&t->lock);
    pthread_cond_destroy(&t->work);
    pthread_cond_destroy(&t->idle);
    pthread_cond_destroy(&t->turned);
    fmb_mem_put(t->mem, t->thread, t->room, sizeof *t->thread);
    *t = (fmb_threads){0};
}

void fmb_threads_start(fmb_threads *t, size_t jobs, fmb_thread_job job, void *self)
{
    pthread_mutex_lock(&t->lock);
    t->job = job;
    t->self = self;
    t->jobs = jobs;
    t->next = t->done = t->turn = 0;
    pthread_cond_broadcast(&t->work);
    pthread_mutex_unlock(&t->lock);
}

void fmb_threads_finish(fmb_threads *t)
{
    pthread_mutex_lock(&t->lock);
    do_jobs_of_round(t, 0);
    while (t->done < t->jobs)
        pthread_cond_wait(&t->idle, &t->lock);
    pthread_mutex_unlock(&t->lock);
}

void fmb_threads_begin_turn(fmb_threads *t, size_t k)
{
    pthread_mutex_lock(&t->lock);
    while (t->turn < k)
        pthread_cond_wait(&t->turned, &t->lock);
    pthread_mutex_unlock(&t->lock);
}

void fmb_threads_end_turn(fmb_threads *t)
{
    pthread_mutex_lock(&t->lock);
    t->turn++;
    pthread_cond_broadcast(&t->turned);
    pthread_mutex_unlock(&t->lock);
}
