/* clock.h: several ways to answer the same queries, timed against each other.
 *
 * A pass answers every query once, one after the other; the ways take turns pass by pass, and the
 * first pass of each is not counted. Times are CPU time of the thread.
 */
#ifndef FMB_STUDY_CLOCK_H
#define FMB_STUDY_CLOCK_H

#include <fmb/base.h>

#include "study/clock/ratio.h"

/* CPU time of this thread [s]. */
double study_thread_seconds(void);

enum { STUDY_CLOCK_MOST_PASSES = 63 };

/* One way: answers queries first ... first + n - 1. An error ends the study. */
typedef struct study_timed {
    fmb_status (*run)(void *self, size_t first, size_t n);
    void *self;
} study_timed;

typedef struct study_clock {
    /* The plan. */
    const study_timed *way; /* [ways], borrowed */
    size_t ways;
    size_t queries;     /* in a pass */
    size_t groups;      /* of nearly equal size, timed separately. 1 ... queries */
    int passes;         /* 1 ... STUDY_CLOCK_MOST_PASSES */
    double max_seconds; /* no further pass begins after that [s, of the wall]; 0 = no limit. The
                           first one always counts */
    /* Called before each pass of a way; false ends the study early. May be NULL. */
    bool (*step)(void *self, size_t done, size_t all);
    void *self;
    /* The results. */
    double *seconds; /* [complete][ways][groups] */
    int complete;    /* passes that all ways finished; 0 only if step ended it */
} study_clock;

/* Errors: ARG (a plan out of range), MEMORY, what a way returned. */
fmb_status study_clock_run(study_clock *c);
void study_clock_clear(study_clock *c);

/* All NaN if no pass is complete. */
typedef struct study_spread {
    double least, median, most;
} study_spread;

/* The mean time of a query in a pass [ns]; its spread over the passes. */
study_spread study_clock_ns(const study_clock *c, size_t way);
/* The median time of way a over that of way b; passes of the same round are paired. */
study_ratio study_clock_ratio(const study_clock *c, size_t a, size_t b);
/* For each group the median over the passes; spread and ratio over the groups. Errors: MEMORY. */
fmb_status study_clock_group_ns(const study_clock *c, size_t way, study_spread *out);
fmb_status study_clock_group_ratio(const study_clock *c, size_t a, size_t b, study_ratio *out);

/* The spread of n numbers; sorts them. */
study_spread study_spread_of(double *x, size_t n);

#endif
