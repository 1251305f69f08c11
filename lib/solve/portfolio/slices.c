/* slices.c: see slices.h. */
#include "solve/portfolio/slices.h"

#include <math.h>

/* Shorter slices would mostly be spent on switching: about a millisecond. */
#define LEAST_SLICE ((uint64_t)1 << 19)
/* A slice is one in so many of what its engine has done. */
#define SLICES 4
/* Estimates are good to a factor of less than that, or wrong altogether (docs/experiments.md). */
#define MARGIN 1.6
/* Runs ahead may take one in so many of what equal slices took. */
#define AHEAD 2

/* Has one done less than the other, for their shares? */
static bool has_done_less(const fmb_slice_engine *a, const fmb_slice_engine *b)
{
    return a->spent * b->share < b->spent * a->share;
}

/* Who has done least. */
static size_t find_least_spent(const fmb_slices *t)
{
    size_t best = SIZE_MAX;
    for (size_t k = 0; k < t->engines; k++)
        if (!t->engine[k].over &&
            (best == SIZE_MAX || has_done_less(&t->engine[k], &t->engine[best])))
            best = k;
    return best;
}

/* Who needs less than half of what any other does, and can end within what runs ahead may take;
 * SIZE_MAX: nobody. */
static size_t find_favourite(const fmb_slices *t)
{
    size_t best = SIZE_MAX;
    double least = INFINITY, second = INFINITY;
    for (size_t k = 0; k < t->engines; k++) {
        if (t->engine[k].over)
            continue;
        if (t->engine[k].left < least) {
            second = least;
            least = t->engine[k].left;
            best = k;
        } else {
            second = fmin(second, t->engine[k].left);
        }
    }
    double allowed = (double)(t->equal / AHEAD) - (double)t->ahead;
    return best != SIZE_MAX && 2 * least < second && MARGIN * least <= allowed ? best : SIZE_MAX;
}

size_t fmb_slices_next(fmb_slices *t, uint64_t *slice)
{
    size_t k = find_favourite(t);
    t->runs_ahead = k != SIZE_MAX;
    if (!t->runs_ahead)
        k = find_least_spent(t);
    const fmb_slice_engine *e = &t->engine[k];
    uint64_t wanted = t->runs_ahead ? (uint64_t)(MARGIN * e->left) : e->spent / SLICES;
    t->slice = *slice = wanted < LEAST_SLICE ? LEAST_SLICE : wanted;
    return k;
}

void fmb_slices_note(fmb_slices *t, size_t engine, uint64_t work)
{
    uint64_t ahead = !t->runs_ahead ? 0 : work < t->slice ? work : t->slice;
    t->engine[engine].spent += work;
    t->ahead += ahead;
    t->equal += work - ahead;
}
