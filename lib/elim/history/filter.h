/* filter.h: histories stored side by side, so that many pairs are refused at once.
 *
 * At the first query of a round the histories of its upper rows, or of all live rows, are laid out
 * in planes for the vector kernels. The history of a row that holds trivially (0 <= 3) is kept
 * after the row is dropped: it still covers other rows.
 */
#ifndef FMB_ELIM_FILTER_H
#define FMB_ELIM_FILTER_H

#include "elim/store/store.h"

/* Planes in an array that grows. */
typedef struct fmb_layout {
    uint64_t *bits;
    size_t capacity; /* words */
    fmb_planes planes;
    bool ready; /* for this round */
} fmb_layout;

typedef struct fmb_filter {
    fmb_layout uppers, rows;
    const uint64_t **silent; /* histories of trivial rows since the base */
    size_t silents, silent_capacity;
    bool wants_silent; /* some rule has queried coverage */
    uint64_t *drop;    /* [capacity] bits of the upper rows, for the rules */
    size_t drop_capacity;
} fmb_filter;

/* fmb_filter_new_round: another round of this base; fmb_filter_forget: another base. */
void fmb_filter_new_round(fmb_filter *f);
void fmb_filter_forget(fmb_filter *f);
void fmb_filter_clear(fmb_filter *f, fmb_mem *mem);

/* A bit set for so many upper rows, all bits 0; NULL on failure. */
uint64_t *fmb_filter_bits(fmb_filter *f, size_t uppers, fmb_mem *mem);

/* The row at the end of the store is trivial: is its history kept, as it may cover others? */
fmb_status fmb_filter_keep_silent(fmb_elim *e, bool *kept);

/* For pairs of a row with the upper rows upper[uppers] of the round: set the bit in drop if the
 * union of the two histories has more than `most` base rows, or if it covers a third row's history.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_filter_drop_larger(fmb_elim *e, uint32_t row, const uint32_t *upper, size_t uppers,
                                  int most, uint64_t *drop);
fmb_status fmb_filter_drop_covered(fmb_elim *e, uint32_t row, const uint32_t *upper, size_t uppers,
                                   uint64_t *drop);

#endif
