/* rule_private.h: the built-in rules that need only the window of <fmb/rule.h>, one rule a file.
 */
#ifndef FMB_RULE_RULE_PRIVATE_H
#define FMB_RULE_RULE_PRIVATE_H

#include <fmb/rule.h>

extern const fmb_rule fmb_rule_box, fmb_rule_chernikov, fmb_rule_dominated, fmb_rule_duplicate,
    fmb_rule_imbert, fmb_rule_kohler;

/* kohler.c: Imbert's rule includes Kohler's. */
void fmb_kohler_drop_pairs(void *state, const fmb_view *w, size_t i, uint64_t *drop);

#endif
