/* run.c: limits, counters and events of one query; see run.h. */
#include "trace/run.h"

#include "base/clock.h"

void fmb_run_begin(fmb_run *run, fmb_mem *mem, const fmb_options *o, const atomic_int *cancel,
                   fmb_sink sink, const char *query)
{
    *run = (fmb_run){.mem = mem, .cancel = cancel, .max_rows = o->max_rows, .sink = sink};
    run->kernels = fmb_kernels_choose(o->simd);
    run->threads = o->threads > 1 ? o->threads : 1;
    run->tells_rows = o->trace_rows && sink.put != NULL;
    run->started = fmb_monotonic_seconds();
    if (o->max_seconds > 0)
        run->deadline = run->started + o->max_seconds;
    mem->limit = o->max_bytes;
    mem->peak = mem->used;
    fmb_run_emit(run, (fmb_event){.kind = FMB_EVENT_BEGIN, .var = -1, .name = query});
}

void fmb_run_end(fmb_run *run, fmb_verdict v)
{
    run->stats.seconds = fmb_monotonic_seconds() - run->started;
    run->stats.bytes_peak = run->mem->peak;
    run->mem->limit = 0;
    fmb_run_emit(run, (fmb_event){.kind = FMB_EVENT_END, .var = -1, .name = fmb_verdict_text(v)});
}

static fmb_status note_first_stop(fmb_run *run, fmb_stop why)
{
    if (run->stop == FMB_STOP_DONE)
        run->stop = why;
    return FMB_LIMIT;
}

/* Apart, as most polls need none of its registers. */
__attribute__((noinline)) fmb_status fmb_run_poll_now(fmb_run *run)
{
    if (run->stop != FMB_STOP_DONE)
        return FMB_LIMIT;
    if (atomic_load_explicit(run->cancel, memory_order_relaxed))
        return note_first_stop(run, FMB_STOP_CANCELLED);
    if (run->deadline > 0 && fmb_monotonic_seconds() >= run->deadline)
        return note_first_stop(run, FMB_STOP_TIME);
    return FMB_OK;
}

fmb_status fmb_run_poll(fmb_run *run)
{
    bool cancelled = atomic_load_explicit(run->cancel, memory_order_relaxed) != 0;
    if (run->stop == FMB_STOP_DONE && !cancelled && (++run->tick & 15) != 0)
        return FMB_OK;
    return fmb_run_poll_now(run);
}

static fmb_status ask_run(void *run)
{
    return fmb_run_poll_now(run);
}

fmb_poll fmb_run_asked(fmb_run *run)
{
    return (fmb_poll){ask_run, run};
}

fmb_status fmb_run_open_num(fmb_run *run, fmb_num *k, size_t n, bool wide_only)
{
    fmb_status st = fmb_num_init(k, run->mem, n, wide_only);
    k->kernels = run->kernels;
    k->poll = fmb_run_asked(run);
    return st;
}

/* The share of the remaining time that is reserved: 1 / RESERVED. */
#define RESERVED 16

void fmb_run_reserve(fmb_run *run)
{
    double left = run->deadline > 0 ? run->deadline - fmb_monotonic_seconds() : 0;
    run->reserve = left > 0 ? left / RESERVED : 0;
    run->deadline -= run->reserve;
}

bool fmb_run_go_on(fmb_run *run)
{
    if (run->stop == FMB_STOP_CANCELLED)
        return false;
    run->deadline += run->reserve;
    run->reserve = 0;
    run->stop = FMB_STOP_DONE;
    return true;
}

fmb_status fmb_run_rows(fmb_run *run, size_t rows)
{
    if (rows > run->stats.rows_peak)
        run->stats.rows_peak = rows;
    if (run->max_rows > 0 && rows > run->max_rows)
        return note_first_stop(run, FMB_STOP_ROWS);
    return FMB_OK;
}

void fmb_run_emit(fmb_run *run, fmb_event e)
{
    if (!run->sink.put)
        return;
    e.seconds = fmb_monotonic_seconds() - run->started;
    if (run->var_of && e.var >= 0)
        e.var = run->var_of[e.var];
    run->sink.put(run->sink.self, &e);
}

void fmb_run_tell_attempt(fmb_run *run, fmb_attempt a, fmb_status st, bool done)
{
    a.unit = a.budget > 0 ? a.unit : NULL;
    a.ended = st == FMB_LIMIT ? "limit"
              : done          ? "answered"
              : a.ended       ? a.ended
              : a.budget > 0  ? "gave up"
                              : "unsuitable";
    if (st == FMB_OK || st == FMB_LIMIT)
        fmb_run_emit(run, (fmb_event){.kind = FMB_EVENT_ENGINE, .var = -1, .attempt = &a});
}

/* ---- shares ---------------------------------------------------------------------------------- */

static size_t share_of_memory(const fmb_mem *mem, size_t shares)
{
    if (mem->limit == 0)
        return 0;
    size_t left = mem->limit > mem->used ? mem->limit - mem->used : 0;
    return left / shares + 1;
}

void fmb_share_begin(fmb_share *s, const fmb_run *run, size_t shares)
{
    fmb_mem_init(&s->mem, &run->mem->alloc, share_of_memory(run->mem, shares));
    s->st = FMB_OK;
    s->run = *run;
    s->run.mem = &s->mem;
    s->run.sink = (fmb_sink){0};
    s->run.tells_rows = false;
    s->run.threads = 1;
    s->run.work = s->run.slice_end = 0;
    s->run.overtaken = NULL;
    s->run.stats = (fmb_stats){0};
}

void fmb_share_end(const fmb_share *s, fmb_run *run, size_t *peak)
{
    run->stats.pairs += s->run.stats.pairs;
    run->stats.pivots += s->run.stats.pivots;
    run->stats.lps += s->run.stats.lps;
    *peak += s->mem.peak;
    if (run->stop == FMB_STOP_DONE)
        run->stop =
            s->st == FMB_LIMIT && s->run.stop == FMB_STOP_DONE ? FMB_STOP_BYTES : s->run.stop;
}
