/* slices.h: whose turn it is, among engines that can be interrupted and continued.
 *
 * Each engine has an expected total work e. After work s without an answer its estimate becomes
 * max(e, s / 4): expectations are often wrong by a factor of four, and an engine that exceeds even
 * that mostly takes as long again. The engine with the least estimate runs until it has done six
 * times the next one's estimate: so the first engine gets no more than that.
 *
 * Bound: let an engine take work w, and m = max(e, w / 4). Until it ends its estimate is at most m.
 * Another engine gets a slice only while its own estimate is at most m, too, and stops when it has
 * done six times the next one's estimate, at most 6 m. So the total is at most w, plus 6 m and a
 * least slice for each other engine. Work is counted (trace/run.h), so the same system is solved
 * the same way everywhere.
 */
#ifndef FMB_SOLVE_SLICES_H
#define FMB_SOLVE_SLICES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define FMB_MOST_ENGINES 3

typedef struct fmb_slice_engine {
    uint64_t spent;  /* work so far */
    double expected; /* its total work */
    bool over;       /* it has given up for good */
} fmb_slice_engine;

typedef struct fmb_slices {
    size_t engines;
    fmb_slice_engine engine[FMB_MOST_ENGINES];
} fmb_slices;

/* The engine whose turn it is, and the work of its slice; 0: no bound, as all others are over. At
 * least one engine is not over. */
size_t fmb_slices_next(const fmb_slices *t, uint64_t *slice);

#endif
