/* simulate.h: how many rows an elimination would make, by signs alone. */
#ifndef FMB_STUDY_SELECTION_SIMULATE_H
#define FMB_STUDY_SELECTION_SIMULATE_H

#include "solve/portfolio/reduced_part.h"

/* More rows are not counted. */
enum { SIMULATED_ROWS = 400 };

/* Of the variables that go, all or until there are SIMULATED_ROWS + 1. */
typedef struct simulated_rows {
    size_t most, last; /* rows at a time, and in the end */
    int left;          /* variables that it did not come to */
} simulated_rows;

/* False: no memory. */
bool simulate_elimination(const fmb_reduced_part *reduced, simulated_rows *out);

#endif
