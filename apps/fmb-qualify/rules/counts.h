/* counts.h: the fewest rows that an elimination needs, on meeting pairs of small frames. */
#ifndef QUALIFY_COUNTS_H
#define QUALIFY_COUNTS_H

#include "fmb-qualify/page.h"
#include "fmb-qualify/rules/plan.h"

/* Count rows and add a table: without rules, with the best set of history rules. An exit code. */
int qualify_counts(const qualify_plan *p, qualify_page *page);

#endif
