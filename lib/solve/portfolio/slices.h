/* slices.h: whose turn it is, among engines that go on where they stopped.
 *
 * Of each engine it is expected how much work e it takes in all. Once it has done s in vain, it is
 * taken to need max(e, s / 4): expectations are often wrong by a factor of four, and what outlives
 * that mostly takes as long again. The engine that needs least goes on, until it has done six times
 * what the next one needs: so the first engine gets no more than that.
 *
 * Bound: let an engine take w, and m = max(e, w / 4). Until it ends it is taken to need no more
 * than m. Another one gets a slice only while it is taken to need no more than that, either, and
 * stops when it has done six times what the next one needs, no more than 6 m. So all of them
 * together do w + 6 m for each other one, and a least slice. Work is counted (trace/run.h), so the
 * same system takes the same way everywhere.
 */
#ifndef FMB_SOLVE_SLICES_H
#define FMB_SOLVE_SLICES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define FMB_MOST_ENGINES 3

typedef struct fmb_slice_engine {
    uint64_t spent;  /* work so far */
    double expected; /* that it takes in all */
    bool over;       /* it has given up for good */
} fmb_slice_engine;

typedef struct fmb_slices {
    size_t engines;
    fmb_slice_engine engine[FMB_MOST_ENGINES];
} fmb_slices;

/* The engine whose turn it is, and the work of its slice; 0: to its end, as all others are over.
 * Some are not over. */
size_t fmb_slices_next(const fmb_slices *t, uint64_t *slice);

#endif
