/* sweep.h: a triangular factor modulo p, by rows in the order of the pivots.
 *
 * Row k is the step v[k] = (v[k] - the sum of value[t] v[index[t]]) scale[k]. A lower factor has
 * only indices below k and is swept upwards, an upper factor the other way.
 */
#ifndef FMB_LP_SWEEP_H
#define FMB_LP_SWEEP_H

#include "base/arena.h"
#include "num/prime.h"

typedef struct fmb_sweep {
    size_t n;
    size_t *start; /* [n + 1] */
    int *index;    /* [room] */
    uint64_t *value;
    uint64_t *scale; /* [n] the inverse of the diagonal, mostly 1 */
    size_t index_room, value_room;
    bool down; /* an upper factor */
} fmb_sweep;

/* No rows yet; about `terms` terms will come. Errors: MEMORY, LIMIT. */
fmb_status fmb_sweep_open(fmb_sweep *w, fmb_arena *arena, size_t n, size_t terms, bool down);
/* Make room for so many terms in total. Errors: MEMORY, LIMIT. */
fmb_status fmb_sweep_reserve(fmb_sweep *w, fmb_arena *arena, size_t terms);
fmb_status fmb_sweep_transpose(const fmb_sweep *w, fmb_arena *arena, fmb_sweep *to);

/* If v is nonzero only at places with reached[n], step[] lists the rows that change v, in order;
 * reached is extended to the places that become nonzero. Returns the number of steps. */
size_t fmb_sweep_reach(const fmb_sweep *w, bool *reached, int *step);
void fmb_sweep_run(const fmb_sweep *w, const fmb_prime *q, const int *step, size_t steps,
                   uint64_t *v);

#endif
