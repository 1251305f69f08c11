/* prune.h: calls the rules at the right moments, with history rules and the others kept apart. */
#ifndef FMB_ELIM_PRUNE_H
#define FMB_ELIM_PRUNE_H

#include "elim/store/store.h"

/* Let rules that read no histories drop live rows before these become the base. Errors: any. */
fmb_status fmb_rules_drop_base_rows(fmb_elim *e);

/* Set the bits of the refused pairs of the i-th lower row with the upper rows of the round, whose
 * lower rows come first. Errors: any. */
fmb_status fmb_rules_refuse_pairs(fmb_elim *e, const fmb_round *round, size_t lowers, size_t i,
                                  uint64_t *drop);

/* The rule that drops the row at the end of the store, or NULL. Errors: any. */
fmb_status fmb_rules_drop_row(fmb_elim *e, const fmb_rule **by);

/* Let the rules drop rows at the end of a round of var (-1: none). A rule may pause
 * (e->at.pruning): the next call continues with it. Errors: any. */
fmb_status fmb_rules_end_round(fmb_elim *e, int var);

#endif
