/* race.h: two methods for the same answer run at once, one of them in another thread; the one that
 * takes less work wins.
 *
 * Work is counted (trace/run.h), and counts alone decide the winner, not which lane ended first, so
 * the winner is the same in every run. As soon as one lane has ended, the other stops when it has
 * done as much work: together they take at most twice the work of the winner, and on one processor
 * at most twice its time.
 */
#ifndef FMB_SOLVE_RACE_H
#define FMB_SOLVE_RACE_H

#include "trace/run.h"

/* Continue until the slice of the lane's run is used up; *ready: the answer is known. */
typedef fmb_status (*fmb_race_way)(void *self, bool *ready);

/* A lane and its result. */
typedef struct fmb_race_lane {
    fmb_run *run;
    fmb_race_way go_on;
    fmb_status st;
    bool ready;
    uint64_t from, spent;         /* work */
    atomic_uint_least64_t beyond; /* work, at which the other lane has overtaken this one */
} fmb_race_lane;

typedef struct fmb_race {
    fmb_race_lane lane[2]; /* run and go_on are input. The runs are that of the query and that of a
                              share, whose memory counts within that of the query */
    void *self;
} fmb_race;

/* *winner: 0 or 1, the lane that is ready with less work; if none is ready, the lane whose error is
 * returned. Errors: MEMORY, LIMIT. */
fmb_status fmb_race_run(fmb_race *r, fmb_mem *mem, fmb_mem *share, size_t *winner);

#endif
