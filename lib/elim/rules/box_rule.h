/* box_rule.h: the box that rows with one variable make, and what it says about other rows.
 *
 * Where variables have one end only, a row that bounds their sum (as of a simplex, x >= 0, sum x <=
 * 1) takes the place of the other ends.
 */
#ifndef FMB_ELIM_RULES_BOX_RULE_H
#define FMB_ELIM_RULES_BOX_RULE_H

#include "elim/store/store.h"

/* The end at which s x_j is least: the lower one for positive s. */
static inline int fmb_box_side_of_least(int64_t s)
{
    return s > 0 ? FMB_LOWER : FMB_UPPER;
}

/* Make the box of the live rows; with it go rows with one variable that another one implies. */
fmb_status fmb_box_make(fmb_elim *e);

/* Note which rows of the base make the box: histories are about to start. */
fmb_status fmb_box_mark(fmb_elim *e);

/* box_slack.c: the sign of the least of b - a.x over the box; -1 also if it is open where it
 * matters, or if the row itself makes the box, or is made of nothing but rows of a box with a
 * budget. */
int fmb_box_slack(const fmb_elim *e, const fmb_derived *r);
/* Does no point of the box satisfy the row? */
bool fmb_box_refutes(const fmb_elim *e, const fmb_derived *r);
/* End the elimination by such a row: combine it with the ends to a clash. Errors: MEMORY, LIMIT. */
fmb_status fmb_box_refute(fmb_elim *e, uint32_t r);

#endif
