/* counts.h: the counts that the project holds itself to, on meeting pairs of small frames. */
#ifndef QUALIFY_COUNTS_H
#define QUALIFY_COUNTS_H

#include "qualify/page.h"
#include "qualify/rules/plan.h"

/* Count and add a table with a line for each bar, with the best set of history rules. An exit code.
 */
int qualify_counts(const qualify_plan *p, qualify_page *page);

#endif
