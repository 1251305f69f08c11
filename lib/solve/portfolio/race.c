/* race.c: see race.h.
 *
 * Let lane 0 be ready, or end, after work w0, and lane 1 be ready after w1. Lane 1 wins if w1 < w0.
 * A lane is stopped only once it has lost: lane 1 at w0, lane 0 beyond w1. So the winner is never
 * stopped, and which lane wins, if any, does not depend on which thread was faster.
 */
#include "solve/portfolio/race.h"

#include "base/threads.h"

static void go_on_in_lane(fmb_race *r, size_t k)
{
    fmb_race_lane *a = &r->lane[k], *other = &r->lane[1 - k];
    a->st = a->go_on(r->self, &a->ready);
    a->spent = a->run->work - a->from;
    if (k == 0 ? a->ready || a->st != FMB_OK : a->st == FMB_OK && a->ready)
        atomic_store_explicit(&other->beyond, other->from + a->spent + (k == 1),
                              memory_order_relaxed);
}

static void go_on_in_other_lane(void *race, size_t job, size_t thread)
{
    (void)job;
    (void)thread;
    go_on_in_lane(race, 1);
}

static void begin_lane(fmb_race_lane *a)
{
    a->from = a->run->work;
    atomic_init(&a->beyond, UINT64_MAX);
    a->run->overtaken = &a->beyond;
}

/* Each lane may take half of the remaining memory. */
static void divide_memory(fmb_mem *mem, fmb_mem *share)
{
    size_t left = mem->limit > mem->used ? (mem->limit - mem->used) / 2 : 0;
    fmb_mem_leave(share);
    if (mem->limit == 0)
        return;
    mem->limit = mem->used + left + 1;
    share->limit = share->used + left + 1;
}

static void unite_memory(fmb_mem *mem, fmb_mem *share, size_t limit)
{
    if (mem->peak < mem->used + share->peak)
        mem->peak = mem->used + share->peak;
    mem->limit = limit;
    share->limit = 0;
    fmb_mem_enter(share, mem);
}

fmb_status fmb_race_run(fmb_race *r, fmb_mem *mem, fmb_mem *share, size_t *winner)
{
    fmb_threads threads;
    size_t limit = mem->limit;
    fmb_race_lane *here = &r->lane[0], *there = &r->lane[1];
    *winner = 0;
    FMB_TRY(fmb_threads_open(&threads, mem, 2));
    begin_lane(here);
    begin_lane(there);
    divide_memory(mem, share);
    fmb_threads_start(&threads, 1, go_on_in_other_lane, r);
    go_on_in_lane(r, 0);
    fmb_threads_finish(&threads);
    unite_memory(mem, share, limit);
    fmb_threads_close(&threads);
    here->run->overtaken = there->run->overtaken = NULL;
    bool over = here->ready || here->st != FMB_OK;
    *winner = there->ready && there->st == FMB_OK && (!over || there->spent < here->spent);
    if (!over && !*winner)
        *winner = 1;
    return r->lane[*winner].st;
}
