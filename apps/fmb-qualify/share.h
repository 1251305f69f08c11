/* share.h: the cells of a study, shared among the ranks that mpirun has started (common/ranks.h):
 * each takes the next cell when it has done its last one. A process alone takes all, in order.
 */
#ifndef QUALIFY_SHARE_H
#define QUALIFY_SHARE_H

#include "fmb-qualify/study.h"

/* Become one of several processes, if mpirun says so: only rank 0 has a standard output. An exit
 * code. Then qualify_leave_ranks is due, with the code of this rank; the code to exit with. */
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
/* All ranks alike: on rank 0, cell [cells], of `size` bytes each, becomes what each of them is
 * where it was done. */
void qualify_share_collect(const qualify_share *s, void *cell, size_t size);
/* Is it for this rank to report, rank 0? */
bool qualify_share_end(qualify_share *s);

#endif
