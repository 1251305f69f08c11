/* prune.h: asking rules: who is asked when. It keeps history rules and the others apart. */
#ifndef FMB_ELIM_PRUNE_H
#define FMB_ELIM_PRUNE_H

#include "elim/store/store.h"

/* Rules that read no histories may drop base rows before they are base rows. Errors: any. */
fmb_status fmb_rules_drop_base_rows(fmb_elim *e);

/* Pairs of the i-th lower row of the round, whose lowers come first, with its upper rows: set the
 * bits of those that are refused. Errors: any. */
fmb_status fmb_rules_refuse_pairs(fmb_elim *e, const fmb_round *round, size_t lowers, size_t i,
                                  uint64_t *drop);

/* The rule that drops the row at the end of the store, or NULL. Errors: any. */
fmb_status fmb_rules_drop_row(fmb_elim *e, const fmb_rule **by);

/* What the rules say when a round of var (-1: none) has ended. A rule may pause (e->at.pruning):
 * the next call goes on with it. Errors: any. */
fmb_status fmb_rules_end_round(fmb_elim *e, int var);

#endif
