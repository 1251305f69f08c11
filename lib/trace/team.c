/* team.c: see team.h. */
#include "trace/team.h"

static void do_job_of_share(void *team, size_t k, size_t thread)
{
    fmb_team *t = team;
    (void)thread;
    t->share[k].st = t->job(t->self, k, &t->share[k].run);
}

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_team_open(fmb_team *t, fmb_run *run, size_t size)
{
    *t = (fmb_team){.run = run};
    t->share = fmb_mem_zero(run->mem, size, sizeof *t->share);
    fmb_status st = t->share ? FMB_OK : fmb_mem_status(run->mem);
    FMB_THEN(st,
             fmb_threads_open(&t->threads, run->mem, run->threads < size ? run->threads : size));
    if (st != FMB_OK) {
        fmb_mem_put(run->mem, t->share, size, sizeof *t->share);
        *t = (fmb_team){.run = run};
        return st;
    }
    t->size = size;
    for (size_t k = 0; k < size; k++)
        fmb_share_begin(&t->share[k], run, size);
    return FMB_OK;
}

void fmb_team_close(fmb_team *t)
{
    fmb_mem *mem = t->run->mem;
    size_t peak = 0;
    fmb_threads_close(&t->threads);
    for (size_t k = 0; k < t->size; k++)
        fmb_share_end(&t->share[k], t->run, &peak);
    fmb_mem_refund(mem, t->held);
    if (mem->used + peak > mem->peak)
        mem->peak = mem->used + peak;
    fmb_mem_put(mem, t->share, t->size, sizeof *t->share);
}

/* ---- rounds ---------------------------------------------------------------------------------- */

/* Until the round ends, each share, and the query's own memory, which the caller goes on using, may
 * grow by an equal part of the remaining memory. */
static void divide_remaining_memory(fmb_team *t)
{
    fmb_mem *mem = t->run->mem;
    size_t left = mem->limit > mem->used ? (mem->limit - mem->used) / (t->size + 1) : 0;
    t->limit = mem->limit;
    if (mem->limit == 0)
        return;
    for (size_t k = 0; k < t->size; k++) {
        size_t limit = t->share[k].mem.used + left;
        t->share[k].mem.limit = limit > 0 ? limit : 1; /* 0 means no limit */
    }
    mem->limit = mem->used + left > 0 ? mem->used + left : 1;
}

static fmb_status charge_memory_of_shares(fmb_team *t)
{
    fmb_mem *mem = t->run->mem;
    fmb_mem_refund(mem, t->held);
    t->held = 0;
    for (size_t k = 0; k < t->size; k++)
        t->held += t->share[k].mem.used;
    fmb_mem_take(mem, t->held);
    return mem->limit > 0 && mem->used > mem->limit ? FMB_LIMIT : FMB_OK;
}

/* The bytes stay charged to the query's memory. */
void fmb_team_hand_over(fmb_team *t, size_t k, size_t bytes)
{
    t->share[k].mem.used -= bytes;
    t->held -= bytes;
}

void fmb_team_start(fmb_team *t, size_t jobs, fmb_team_job job, void *self)
{
    divide_remaining_memory(t);
    t->job = job;
    t->self = self;
    t->jobs = jobs;
    fmb_threads_start(&t->threads, jobs, do_job_of_share, t);
}

fmb_status fmb_team_finish(fmb_team *t)
{
    fmb_status worst = FMB_OK;
    fmb_threads_finish(&t->threads);
    t->run->mem->limit = t->limit;
    for (size_t k = 0; k < t->jobs; k++) {
        fmb_share *s = &t->share[k];
        fmb_run_count(t->run, s->run.work);
        s->run.work = 0;
        if (worst == FMB_OK || (worst == FMB_LIMIT && s->st != FMB_OK))
            worst = s->st;
        if (t->run->stop == FMB_STOP_DONE)
            t->run->stop = s->run.stop;
    }
    fmb_status st = charge_memory_of_shares(t);
    return worst != FMB_OK ? worst : st;
}
