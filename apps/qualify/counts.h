/* counts.h: the counts that the project holds itself to, on meeting pairs of small frames. */
#ifndef QUALIFY_COUNTS_H
#define QUALIFY_COUNTS_H

#include "qualify/plan.h"

/* Count and print a line for each bar, with the best set of history rules. An exit code. */
int qualify_counts(const qualify_plan *p);

#endif
