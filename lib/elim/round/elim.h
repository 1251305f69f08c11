/* elim.h: Fourier-Motzkin elimination on integer rows with their derivations.
 *
 * A round eliminates one variable: by substitution if an equality contains it, else by pairing rows
 * of opposite sign. Source: Fourier 1827; Motzkin 1936; Schrijver 1986, section 12.2.
 */
#ifndef FMB_ELIM_ELIM_H
#define FMB_ELIM_ELIM_H

#include "elim/store/store.h"

/* Options of the caller; borrowed. */
typedef struct fmb_elim_options {
    fmb_order order;
    fmb_rebase rebase;
    unsigned steps; /* of fmb_step */
    bool wide_only;
    fmb_chooser chooser;
    const fmb_rule *const *rule;
    int rules;
} fmb_elim_options;

/* An empty store over n variables. Errors: MEMORY, LIMIT; call fmb_elim_clear even then. */
fmb_status fmb_elim_init(fmb_elim *e, fmb_run *run, fmb_arena *arena, int n,
                         const fmb_elim_options *o);
void fmb_elim_clear(fmb_elim *e);

/* Between rounds: drop the live rows that the rules refuse. */
fmb_status fmb_elim_prune(fmb_elim *e);

/* Eliminate all variables with drop[var], in the engine's order, until all are done, a row clashes,
 * or, with cheap_only, the next variable is not cheap; or until it pauses. */
fmb_status fmb_elim_eliminate(fmb_elim *e, const bool *drop);

#endif
