/* simulate.h: about how many rows an elimination would make, by signs alone. */
#ifndef FMB_STUDY_SELECTION_SIMULATE_H
#define FMB_STUDY_SELECTION_SIMULATE_H

#include "elim/store/store.h"

/* More rows at a time are not followed, nor more rows to begin with, variables that go, and pairs:
 * tens of microseconds. */
enum { SIMULATED_ROWS = 384, SIMULATED_BASE = 256, SIMULATED_COLUMNS = 64, SIMULATED_PAIRS = 1024 };

/* Of the variables that go, all or until there were too many rows. */
typedef struct simulated_elimination {
    size_t most;  /* rows at a time, at least so many */
    size_t pairs; /* of rows that were combined, at least so many */
    int left;     /* variables that it did not come to */
    long first;   /* rows that are more after the first variable, by pairs; negative: fewer */
} simulated_elimination;

/* Of e's live rows, drop[n] the variables that go. e stays as it is. */
simulated_elimination simulate_elimination(const fmb_elim *e, const bool *drop);

#endif
