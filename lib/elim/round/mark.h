/* mark.h: a saved state of an elimination, to return to it and continue differently.
 *
 * Returning forgets the rows made since the mark and reuses their memory. The state of the
 * elimination and of its rules is restored; only counters of work keep their values. A mark may be
 * returned to any number of times, but not after a return to an earlier mark.
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
    fmb_elim then; /* rounds change the pointees, except those copied below */
    fmb_kept_copy kept[8 + FMB_MAX_RULES];
    int keeps;
    uint64_t **history; /* [live]: a re-base replaces those of live rows */
    const uint64_t **silent;
    size_t silents, silent_capacity;
    fmb_arena_place place;
} fmb_mark;

/* Can the state of every rule be copied? Not if a rule owns memory (fmb_rule.clear). */
bool fmb_mark_possible(const fmb_elim *e);

/* Between rounds. Errors: MEMORY, LIMIT. */
fmb_status fmb_mark_set(fmb_mark *m, fmb_elim *e);
void fmb_mark_return(const fmb_mark *m, fmb_elim *e);

#endif
