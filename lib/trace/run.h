/* run.h: what one query carries along: its memory, its limits, its counters, and who watches.
 *
 * Long loops call fmb_run_poll; once a limit is reached every later call says FMB_LIMIT too, and
 * run->stop keeps the first reason. Nothing here is an error: the verbs turn FMB_LIMIT into a
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
    double reserve;           /* kept for what follows a limit [s] */
    size_t max_rows;          /* live rows; 0 = none */
    size_t threads;           /* that may work on it, at least 1 */
    unsigned tick;            /* polls so far: the clock is read at every 16th */
    uint64_t work;            /* done so far: fmb_run_count */
    uint64_t slice_end; /* an engine that can go on later stops at so much work; 0: none does */
    const atomic_uint_least64_t *overtaken; /* at so much, too, which another thread may lower; or
                                               NULL */
    fmb_stats stats;
    fmb_sink sink;
    bool tells_rows;   /* the watcher wants to know of every row */
    const int *var_of; /* the watcher's variable of each column, NULL: the same */
} fmb_run;

void fmb_run_begin(fmb_run *run, fmb_mem *mem, const fmb_options *o, const atomic_int *cancel,
                   fmb_sink sink, const char *query);
/* Fill in the times and bytes of run->stats; tell the watcher the answer. */
void fmb_run_end(fmb_run *run, fmb_verdict v);

/* A share of a query for one thread: with the same limits, memory and counts of its own (out of
 * what is left of the memory that is limited, one of so many shares), and nobody watching. */
typedef struct fmb_share {
    fmb_mem mem;
    fmb_run run;
    fmb_status st; /* of what was done */
} fmb_share;

/* The share must not move. */
void fmb_share_begin(fmb_share *s, const fmb_run *run, size_t shares);
/* What was done counts for the query; *peak [bytes] of all shares grows by that of this one. */
void fmb_share_end(const fmb_share *s, fmb_run *run, size_t *peak);

/* Inner loops count what they do, in steps of about a nanosecond each: the same on every machine,
 * as no clock is asked, so that an engine that stops by it stops at the same place everywhere.
 * Measured on projections of all families, nine of ten of each engine: a step took 0.4 to 1.3 ns,
 * as what is done with long numbers is counted by their limbs (num/work.h). What a share counts is
 * counted for the query when its round ends. */
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
/* The same, with the clock read at every call: before long steps. */
fmb_status fmb_run_poll_now(fmb_run *run);
/* Behind a step with numbers that are wide, or are not: wide ones may be of any length, and one
 * step as long as many others. */
static inline fmb_status fmb_run_poll_step(fmb_run *run, bool wide)
{
    return wide ? fmb_run_poll_now(run) : fmb_run_poll(run);
}
/* Behind an operation with z: one of so many limbs takes a tenth of a millisecond and more. */
#define FMB_LONG_LIMBS 1024
static inline fmb_status fmb_run_poll_long(fmb_run *run, const mpz_t z)
{
    return mpz_size(z) >= FMB_LONG_LIMBS ? fmb_run_poll_now(run) : FMB_OK;
}
/* The same as fmb_run_poll_now; FMB_OK without a run. */
static inline fmb_status fmb_poll_if_limited(fmb_run *run)
{
    return run ? fmb_run_poll_now(run) : FMB_OK;
}
/* Somebody to ask: the query, with the clock read each time. */
fmb_poll fmb_run_asked(fmb_run *run);
/* What operations of the query on vecs of at most n entries need: with its memory and kernels, and
 * the query is asked within long ones. In any case fmb_num_clear it. Errors: MEMORY, LIMIT. */
fmb_status fmb_run_open_num(fmb_run *run, fmb_num *k, size_t n, bool wide_only);
/* Keep a share of the time that is left for what follows a limit: fmb_run_go_on. */
void fmb_run_reserve(fmb_run *run);
/* After a limit: go on, with the time that was kept; false after a cancel, as then nothing goes on.
 */
bool fmb_run_go_on(fmb_run *run);
/* Is there any limit but a cancel? */
static inline bool fmb_run_is_limited(const fmb_run *run)
{
    return run->deadline > 0 || run->max_rows > 0 || run->mem->limit > 0;
}
/* Note that `rows` rows are alive: keeps the peak, checks the limit. */
fmb_status fmb_run_rows(fmb_run *run, size_t rows);

void fmb_run_emit(fmb_run *run, fmb_event e);
/* Tell how an engine fared, which returned st (after errors nothing is told): done, it answered;
 * else a.ended says how it ended, unless it is NULL. */
void fmb_run_tell_attempt(fmb_run *run, fmb_attempt a, fmb_status st, bool done);

#endif
