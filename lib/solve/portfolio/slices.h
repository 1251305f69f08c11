/* slices.h: whose turn it is, among engines that go on where they stopped.
 *
 * All get slices such that each has done as much as the others, or its share of that: then the
 * first to answer costs so many times its own work as there are shares for one of its own, and no
 * more, whatever anyone expects. An engine that thinks it needs less than half of what any other
 * does may run ahead to its end; what such runs did in vain stays below a share of what the equal
 * slices did. Work is counted (trace/run.h), so the same system takes the same way everywhere.
 */
#ifndef FMB_SOLVE_SLICES_H
#define FMB_SOLVE_SLICES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define FMB_MOST_ENGINES 3

typedef struct fmb_slice_engine {
    uint64_t spent; /* work so far */
    double left;    /* that it thinks it needs yet; INFINITY: it cannot tell */
    bool over;      /* it has given up for good */
    uint64_t share; /* so many parts of the equal slices are its own, at least 1 */
} fmb_slice_engine;

typedef struct fmb_slices {
    size_t engines;
    fmb_slice_engine engine[FMB_MOST_ENGINES];
    uint64_t equal, ahead; /* work of equal slices, and of runs ahead */
    bool runs_ahead;       /* the slice at hand is one of the latter, */
    uint64_t slice;        /* and so long: what takes longer belongs to the equal ones */
} fmb_slices;

/* The engine whose turn it is, and the work of its slice. Some are not over. */
size_t fmb_slices_next(fmb_slices *t, uint64_t *slice);
/* It has done so much. */
void fmb_slices_note(fmb_slices *t, size_t engine, uint64_t work);

#endif
