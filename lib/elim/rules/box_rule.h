/* box_rule.h: the box that rows with one variable make, and what it says about other rows.
 */
#ifndef FMB_ELIM_RULES_BOX_RULE_H
#define FMB_ELIM_RULES_BOX_RULE_H

#include "elim/store/store.h"

/* Make the box of the live rows; with it go rows with one variable that another one implies. */
fmb_status fmb_box_make(fmb_elim *e);

/* box_slack.c: the sign of the least of b - a.x over the box; -1 also if it is open where it
 * matters, or if the row itself makes the box. */
int fmb_box_slack(const fmb_elim *e, const fmb_derived *r);
/* Does no point of the box satisfy the row? */
bool fmb_box_refutes(const fmb_elim *e, const fmb_derived *r);
/* End the elimination by such a row: combine it with the ends to a clash. Errors: MEMORY, LIMIT. */
fmb_status fmb_box_refute(fmb_elim *e, uint32_t r);

#endif
