/* box_rule.h: the box of the rows with one variable, and what it implies for other rows.
 *
 * If variables have one end only, a row that bounds their sum (as of a simplex, x >= 0, sum x <= 1)
 * replaces the other ends: the budget.
 */
#ifndef FMB_ELIM_RULES_BOX_RULE_H
#define FMB_ELIM_RULES_BOX_RULE_H

#include "elim/store/store.h"

/* The end at which s x_j is least: the lower one if s > 0, otherwise the upper one. */
static inline int fmb_box_side_of_least(int64_t s)
{
    return s > 0 ? FMB_LOWER : FMB_UPPER;
}

/* Make the box of the live rows; rows with one variable that another one implies are dropped. */
fmb_status fmb_box_make(fmb_elim *e);

/* Note which base rows make the box, at the start of histories. */
fmb_status fmb_box_mark(fmb_elim *e);

/* box_slack.c: the sign of the least b - a.x over the box; also -1 if the box is open at that
 * corner, if the row itself makes the box, or if only rows of the box were combined to it and the
 * box has a budget. */
int fmb_box_slack(const fmb_elim *e, const fmb_derived *r);
/* Does the row fail at every point of the box? */
bool fmb_box_refutes(const fmb_elim *e, const fmb_derived *r);
/* For such a row: combine it with the ends of the box to a clash. Errors: MEMORY, LIMIT. */
fmb_status fmb_box_refute(fmb_elim *e, uint32_t r);

#endif
