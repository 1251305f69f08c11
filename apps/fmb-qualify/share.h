/* share.h: the cells of a study, shared among the ranks that mpirun has started (common/ranks.h):
 * each rank takes the next free cell when it is done with one. A single process takes all, in
 * order. */
#ifndef QUALIFY_SHARE_H
#define QUALIFY_SHARE_H

#include "fmb-qualify/study.h"

/* Join the ranks if started by mpirun: only rank 0 has a standard output. An exit code. At the end
 * call qualify_leave_ranks with this rank's exit code; it returns the common one. */
int qualify_join_ranks(void);
int qualify_leave_ranks(int code);

typedef struct qualify_share {
    size_t counter, cells;
    bool *mine; /* [cells] done by this rank */
} qualify_share;

/* [give, qualify_share_end] All ranks alike. */
qualify_share qualify_share_begin(const qualify_setup *o, size_t cells);
/* *i becomes the next cell for this rank; false: there is none, or a signal came. */
bool qualify_share_next(qualify_share *s, size_t *i);
/* All ranks call this: on rank 0 each element of cell [cells], of `size` bytes, becomes that of the
 * rank that did it. */
void qualify_share_collect(const qualify_share *s, void *cell, size_t size);
/* Is this rank 0, which reports? */
bool qualify_share_end(qualify_share *s);

#endif
