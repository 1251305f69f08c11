/* team.c: see team.h. */
#include "trace/team.h"

/* ---- threads --------------------------------------------------------------------------------- */

/* Take jobs until there are none, holding the lock in between. */
static void do_jobs_of_round(fmb_team *t)
{
    while (t->next < t->jobs) {
        size_t k = t->next++;
        pthread_mutex_unlock(&t->lock);
        t->share[k].st = t->job(t->self, k, &t->share[k].run);
        pthread_mutex_lock(&t->lock);
        if (++t->done == t->jobs)
            pthread_cond_signal(&t->idle);
    }
}

static void *work_in_team(void *team)
{
    fmb_team *t = team;
    pthread_mutex_lock(&t->lock);
    while (!t->over) {
        do_jobs_of_round(t);
        if (!t->over)
            pthread_cond_wait(&t->work, &t->lock);
    }
    pthread_mutex_unlock(&t->lock);
    return NULL;
}

/* The system may refuse threads: the others do the work. */
static void start_threads(fmb_team *t)
{
    size_t wanted = (t->run->threads < t->size ? t->run->threads : t->size) - 1;
    pthread_mutex_init(&t->lock, NULL);
    pthread_cond_init(&t->work, NULL);
    pthread_cond_init(&t->idle, NULL);
    while (t->threads < wanted &&
           pthread_create(&t->thread[t->threads], NULL, work_in_team, t) == 0)
        t->threads++;
}

static void end_threads(fmb_team *t)
{
    pthread_mutex_lock(&t->lock);
    t->over = true;
    pthread_cond_broadcast(&t->work);
    pthread_mutex_unlock(&t->lock);
    for (size_t k = 0; k < t->threads; k++)
        pthread_join(t->thread[k], NULL);
    pthread_mutex_destroy(&t->lock);
    pthread_cond_destroy(&t->work);
    pthread_cond_destroy(&t->idle);
}

static void do_all_jobs(fmb_team *t, size_t jobs, fmb_team_job job, void *self)
{
    pthread_mutex_lock(&t->lock);
    t->job = job;
    t->self = self;
    t->jobs = jobs;
    t->next = t->done = 0;
    pthread_cond_broadcast(&t->work);
    do_jobs_of_round(t);
    while (t->done < t->jobs)
        pthread_cond_wait(&t->idle, &t->lock);
    pthread_mutex_unlock(&t->lock);
}

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_team_open(fmb_team *t, fmb_run *run, size_t size)
{
    *t = (fmb_team){.run = run};
    t->share = fmb_mem_zero(run->mem, size, sizeof *t->share);
    t->thread = fmb_mem_zero(run->mem, run->threads, sizeof *t->thread);
    if (!t->share || !t->thread) {
        fmb_status st = fmb_mem_status(run->mem);
        fmb_mem_put(run->mem, t->share, size, sizeof *t->share);
        fmb_mem_put(run->mem, t->thread, run->threads, sizeof *t->thread);
        *t = (fmb_team){.run = run};
        return st;
    }
    t->size = size;
    for (size_t k = 0; k < size; k++)
        fmb_share_begin(&t->share[k], run, size);
    start_threads(t);
    return FMB_OK;
}

void fmb_team_close(fmb_team *t)
{
    fmb_mem *mem = t->run->mem;
    size_t peak = 0;
    if (t->size > 0)
        end_threads(t);
    for (size_t k = 0; k < t->size; k++)
        fmb_share_end(&t->share[k], t->run, &peak);
    fmb_mem_refund(mem, t->held);
    if (mem->used + peak > mem->peak)
        mem->peak = mem->used + peak;
    fmb_mem_put(mem, t->share, t->size, sizeof *t->share);
    fmb_mem_put(mem, t->thread, t->run->threads, sizeof *t->thread);
}

/* ---- rounds ---------------------------------------------------------------------------------- */

/* Each share may grow by its part of what is left. */
static void divide_what_is_left(fmb_team *t)
{
    fmb_mem *mem = t->run->mem;
    size_t left = mem->limit > mem->used ? (mem->limit - mem->used) / t->size : 0;
    for (size_t k = 0; mem->limit > 0 && k < t->size; k++) {
        size_t limit = t->share[k].mem.used + left;
        t->share[k].mem.limit = limit > 0 ? limit : 1; /* 0 were none */
    }
}

static fmb_status count_what_shares_hold(fmb_team *t)
{
    fmb_mem *mem = t->run->mem;
    fmb_mem_refund(mem, t->held);
    t->held = 0;
    for (size_t k = 0; k < t->size; k++)
        t->held += t->share[k].mem.used;
    fmb_mem_take(mem, t->held);
    return mem->limit > 0 && mem->used > mem->limit ? FMB_LIMIT : FMB_OK;
}

/* It stays counted where it is. */
void fmb_team_hand_over(fmb_team *t, size_t k, size_t bytes)
{
    t->share[k].mem.used -= bytes;
    t->held -= bytes;
}

fmb_status fmb_team_do(fmb_team *t, size_t jobs, fmb_team_job job, void *self)
{
    fmb_status worst = FMB_OK;
    divide_what_is_left(t);
    do_all_jobs(t, jobs, job, self);
    for (size_t k = 0; k < jobs; k++) {
        const fmb_share *s = &t->share[k];
        if (worst == FMB_OK || (worst == FMB_LIMIT && s->st != FMB_OK))
            worst = s->st;
        if (t->run->stop == FMB_STOP_DONE)
            t->run->stop = s->run.stop;
    }
    fmb_status st = count_what_shares_hold(t);
    return worst != FMB_OK ? worst : st;
}
