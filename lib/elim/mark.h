/* mark.h: an elimination as it was, to come back to it and go on another way.
 *
 * Rows made since are forgotten, and their memory is used again. Everything that the elimination
 * and its rules knew is known again; only counters of work go on. A mark may be returned to any
 * number of times, but not after an earlier mark has been returned to.
 */
#ifndef FMB_ELIM_MARK_H
#define FMB_ELIM_MARK_H

#include "elim/elim.h"

typedef struct fmb_mark {
    fmb_elim then;           /* what pointers show is changed by rounds, but for the copies below */
    uint32_t *live;          /* [live] */
    uint64_t **history;      /* [live]: a re-base gives live rows new ones */
    const uint64_t **silent; /* [silents] */
    size_t silents, silent_capacity;
    const uint64_t **silent_place;
    uint64_t *gone;             /* [columns] */
    uint32_t *box_row[2];       /* [side][n] */
    int64_t *box_end[2];        /* [side][n] */
    void *state[FMB_MAX_RULES]; /* of each rule */
    fmb_arena_place place;
} fmb_mark;

/* Can the state of every rule be copied? Not if it owns something (fmb_rule.clear). */
bool fmb_mark_possible(const fmb_elim *e);

/* Between rounds. Errors: MEMORY, LIMIT. */
fmb_status fmb_mark_set(fmb_mark *m, fmb_elim *e);
void fmb_mark_return(const fmb_mark *m, fmb_elim *e);

#endif
