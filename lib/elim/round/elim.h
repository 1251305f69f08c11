/* elim.h: Fourier-Motzkin elimination on integer rows that know where they come from.
 *
 * A round eliminates one variable: by substitution if an equality contains it, else by pairing rows
 * of opposite sign. Source: Fourier 1827; Motzkin 1936; Schrijver 1986, section 12.2.
 */
#ifndef FMB_ELIM_ELIM_H
#define FMB_ELIM_ELIM_H

#include "elim/store/store.h"

/* What a caller decides; borrowed. */
typedef struct fmb_elim_options {
    fmb_order order;
    fmb_rebase rebase;
    unsigned steps; /* of fmb_step */
    bool wide_only;
    fmb_chooser chooser;
    const fmb_rule *const *rule;
    int rules;
} fmb_elim_options;

/* An empty store over n variables. Errors: MEMORY, LIMIT. In any case fmb_elim_clear it. */
fmb_status fmb_elim_init(fmb_elim *e, fmb_run *run, fmb_arena *arena, int n,
                         const fmb_elim_options *o);
void fmb_elim_clear(fmb_elim *e);

/* Drop live rows as the rules say, between rounds. */
fmb_status fmb_elim_prune(fmb_elim *e);

/* Eliminate all variables with drop[var], in the engine's order, until done, a row clashes or, if
 * the store is so set, what comes next is not cheap; or until it pauses. */
fmb_status fmb_elim_eliminate(fmb_elim *e, const bool *drop);

#endif
