/* pair_counts.h: the counters of an fmb_pair, as a value. */
#ifndef FMB_TEST_PAIR_COUNTS_H
#define FMB_TEST_PAIR_COUNTS_H

#include <stdlib.h>

#include <fmb/pair.h>

static inline fmb_pair_counts counts_of_pairs(const fmb_pair *k)
{
    fmb_pair_counts counts = {.size = sizeof counts};
    if (fmb_pair_count(k, &counts) != FMB_OK)
        abort();
    return counts;
}

#endif
