/* slices.c: see slices.h. */
#include "solve/portfolio/slices.h"

#include <math.h>

/* About a tenth of a millisecond: shorter slices would mostly be spent on switching. */
#define LEAST_SLICE ((double)(1 << 16))
/* Expectations are correct up to this factor (docs/experiments.md). */
#define PATIENCE 4
/* Slices of engines that take turns grow by this factor. */
#define LONGER 1.5

static double work_needed(const fmb_slice_engine *e)
{
    return fmax(e->expected, (double)e->spent / PATIENCE);
}

size_t fmb_slices_next(const fmb_slices *t, uint64_t *slice)
{
    size_t best = SIZE_MAX;
    double least = INFINITY, second = INFINITY;
    for (size_t k = 0; k < t->engines; k++) {
        if (t->engine[k].over)
            continue;
        double needed = work_needed(&t->engine[k]);
        if (best == SIZE_MAX || needed < least) {
            second = least;
            least = needed;
            best = k;
        } else {
            second = fmin(second, needed);
        }
    }
    double until = LONGER * PATIENCE * second - (double)t->engine[best].spent;
    *slice = isinf(second) ? 0 : (uint64_t)fmin(fmax(until, LEAST_SLICE), 0x1p62);
    return best;
}
