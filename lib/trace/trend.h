/* trend.h: how the work of steps grows, and so how much is left.
 *
 * An elimination takes a variable at a step, double description a row. A step mostly takes so many
 * times the work of the one before, and that factor changes slowly. Work is what fmb_run_count
 * counts; that of others, between a pause and where it goes on, does not belong to it.
 */
#ifndef FMB_TRACE_TREND_H
#define FMB_TRACE_TREND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct fmb_trend {
    uint64_t since; /* work at which it went on last */
    double now;     /* work of the step on its way, until the last pause */
    size_t steps;   /* that have ended */
    double length;  /* logarithm of the work of a step, */
    double growth;  /* and how much that grows from one to the next, of late */
} fmb_trend;

/* `work` is that of the run so far. */
static inline void fmb_trend_go_on(fmb_trend *t, uint64_t work)
{
    t->since = work;
}
static inline void fmb_trend_pause(fmb_trend *t, uint64_t work)
{
    t->now += (double)(work - t->since);
    t->since = work;
}
void fmb_trend_end_step(fmb_trend *t, uint64_t work);

/* Paused: how much work is left in so many steps, of the first of which that share is done, 0 to 1?
 * INFINITY: there is nothing to tell it by. */
double fmb_trend_left(const fmb_trend *t, double share, size_t steps);

#endif
