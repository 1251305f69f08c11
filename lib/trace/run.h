/* run.h: the context of one query: its memory, its limits, its counters, and its watcher.
 *
 * Long loops call fmb_run_poll. Once a limit is reached every later call returns FMB_LIMIT too, and
 * run->stop keeps the first reason. A limit is not an error: the verbs turn FMB_LIMIT into a
 * result.
 */
#ifndef FMB_TRACE_RUN_H
#define FMB_TRACE_RUN_H

#include <stdatomic.h>

#include <fmb/options.h>
#include <fmb/solve.h>
#include <fmb/trace.h>

#include "base/mem.h"
#include "base/poll.h"
#include "num/vec.h"

typedef struct fmb_run {
    fmb_mem *mem;
    const fmb_kernels *kernels;
    const atomic_int *cancel; /* not 0: stop */
    fmb_stop stop;            /* the first limit reached */
    double started, deadline; /* monotonic clock [s]; deadline 0 = none */
    double reserve;           /* time kept for the work after a limit [s] */
    size_t max_rows;          /* live rows; 0 = none */
    size_t threads;           /* that may work on the query, at least 1 */
    unsigned tick;            /* polls so far: the clock is read at every 16th */
    uint64_t work;            /* done so far: fmb_run_count */
    uint64_t slice_end;       /* resumable engines pause at this much work; 0: never */
    const atomic_uint_least64_t *overtaken; /* at so much, too, which another thread may lower; or
                                               NULL */
    fmb_stats stats;
    fmb_sink sink;
    bool tells_rows;   /* the watcher wants an event for every row */
    const int *var_of; /* the watcher's variable of each column, NULL: the same */
} fmb_run;

void fmb_run_begin(fmb_run *run, fmb_mem *mem, const fmb_options *o, const atomic_int *cancel,
                   fmb_sink sink, const char *query);
/* Fill in the times and bytes of run->stats; emit the answer to the watcher. */
void fmb_run_end(fmb_run *run, fmb_verdict v);

/* A share of a query for one thread: the same limits, its own memory and counts (if memory is
 * limited, one of so many equal parts of the remaining memory), and no watcher. */
typedef struct fmb_share {
    fmb_mem mem;
    fmb_run run;
    fmb_status st; /* the status of the share's work */
} fmb_share;

/* The share must not move. */
void fmb_share_begin(fmb_share *s, const fmb_run *run, size_t shares);
/* Add the counts of the share to the query's; *peak [bytes] grows by the peak of this share. */
void fmb_share_end(const fmb_share *s, fmb_run *run, size_t *peak);

/* Inner loops count their work, in steps of about a nanosecond: the same on every machine, as no
 * clock is read, so an engine that stops by this count stops at the same place everywhere. Measured
 * on projections of all families, for nine of ten of each engine: a step took 0.4 to 1.3 ns, as
 * work on long numbers is counted by their limbs (num/work.h). The work of a share is added to that
 * of the query when its round ends. */
static inline void fmb_run_count(fmb_run *run, uint64_t steps)
{
    run->work += steps;
}
static inline bool fmb_run_is_overtaken(const fmb_run *run)
{
    return run->overtaken &&
           run->work >= atomic_load_explicit(run->overtaken, memory_order_relaxed);
}
static inline bool fmb_run_is_slice_over(const fmb_run *run)
{
    return (run->slice_end > 0 && run->work >= run->slice_end) || fmb_run_is_overtaken(run);
}

/* FMB_OK, or FMB_LIMIT when the query must stop. Cheap. */
fmb_status fmb_run_poll(fmb_run *run);
/* Like fmb_run_poll, but the clock is read at every call: before long steps. */
fmb_status fmb_run_poll_now(fmb_run *run);
/* After a step on small or wide numbers: wide ones may have any length, so one step may take as
 * long as many others, and the clock is read. */
static inline fmb_status fmb_run_poll_step(fmb_run *run, bool wide)
{
    return wide ? fmb_run_poll_now(run) : fmb_run_poll(run);
}
/* After an operation on z: with this many limbs it takes at least a tenth of a millisecond. */
#define FMB_LONG_LIMBS 1024
static inline fmb_status fmb_run_poll_long(fmb_run *run, const mpz_t z)
{
    return mpz_size(z) >= FMB_LONG_LIMBS ? fmb_run_poll_now(run) : FMB_OK;
}
/* fmb_run_poll_now, or FMB_OK if run is NULL. */
static inline fmb_status fmb_poll_if_limited(fmb_run *run)
{
    return run ? fmb_run_poll_now(run) : FMB_OK;
}
/* A poll that asks the query, reading the clock each time. */
fmb_poll fmb_run_asked(fmb_run *run);
/* The context of operations on vecs of at most n entries: memory, kernels and poll are the query's.
 * The caller must call fmb_num_clear even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_run_open_num(fmb_run *run, fmb_num *k, size_t n, bool wide_only);
/* Keep a part of the remaining time for the work after a limit: fmb_run_go_on. */
void fmb_run_reserve(fmb_run *run);
/* After a limit: go on within the time that was kept; false after a cancel, which ends everything.
 */
bool fmb_run_go_on(fmb_run *run);
/* Is there any limit but a cancel? */
static inline bool fmb_run_is_limited(const fmb_run *run)
{
    return run->deadline > 0 || run->max_rows > 0 || run->mem->limit > 0;
}
/* Note that `rows` rows are live: updates the peak, checks the limit. */
fmb_status fmb_run_rows(fmb_run *run, size_t rows);

void fmb_run_emit(fmb_run *run, fmb_event e);
/* Emit how the attempt of an engine ended, which returned st (nothing after errors). done: it
 * answered; else a.ended names the reason, or is NULL for a default one. */
void fmb_run_tell_attempt(fmb_run *run, fmb_attempt a, fmb_status st, bool done);

#endif
