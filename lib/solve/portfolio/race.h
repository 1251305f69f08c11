/* race.h: two ways to the same answer at once, one of them by another thread; the one that takes
 * less work wins.
 *
 * Work is counted (trace/run.h), and who wins is told by counts alone, not by who ended first: so
 * it is the same at every run. As soon as one has ended, the other one stops where it has done as
 * much: so both together take twice the work of the winner, and twice as long as it took are both
 * by one thread.
 */
#ifndef FMB_SOLVE_RACE_H
#define FMB_SOLVE_RACE_H

#include "trace/run.h"

/* Go on until a slice of the lane's run is over; *ready: the answer is known. */
typedef fmb_status (*fmb_race_way)(void *self, bool *ready);

/* A lane, and how it fared. */
typedef struct fmb_race_lane {
    fmb_run *run;
    fmb_race_way go_on;
    fmb_status st;
    bool ready;
    uint64_t from, spent;         /* work */
    atomic_uint_least64_t beyond; /* work, at which the other lane has overtaken this one */
} fmb_race_lane;

typedef struct fmb_race {
    fmb_race_lane lane[2]; /* run and go_on are given: that of the query, and that of a share, whose
                              memory counts within that of the query */
    void *self;
} fmb_race;

/* *winner: 0 or 1, the lane that is ready first; where there is none, that which stopped the race
 * by what is returned: MEMORY or LIMIT. */
fmb_status fmb_race_run(fmb_race *r, fmb_mem *mem, fmb_mem *share, size_t *winner);

#endif
