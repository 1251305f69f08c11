/* mark.h: an elimination as it was, to come back to it and go on another way.
 *
 * Rows made since are forgotten, and their memory is used again. Everything that the elimination
 * and its rules knew is known again; only counters of work go on. A mark may be returned to any
 * number of times, but not after an earlier mark has been returned to.
 */
#ifndef FMB_ELIM_MARK_H
#define FMB_ELIM_MARK_H

#include "elim/store/store.h"

typedef struct fmb_kept_copy {
    void *at;
    const void *copy;
    size_t bytes;
} fmb_kept_copy;

typedef struct fmb_mark {
    fmb_elim then; /* what pointers show is changed by rounds, but for the copies below */
    fmb_kept_copy kept[7 + FMB_MAX_RULES];
    int keeps;
    uint64_t **history; /* [live]: a re-base gives live rows new ones */
    const uint64_t **silent;
    size_t silents, silent_capacity;
    fmb_arena_place place;
} fmb_mark;

/* Can the state of every rule be copied? Not if it owns something (fmb_rule.clear). */
bool fmb_mark_possible(const fmb_elim *e);

/* Between rounds. Errors: MEMORY, LIMIT. */
fmb_status fmb_mark_set(fmb_mark *m, fmb_elim *e);
void fmb_mark_return(const fmb_mark *m, fmb_elim *e);

#endif
