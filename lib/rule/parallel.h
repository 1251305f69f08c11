/* parallel.h: rows that are positive multiples of each other. */
#ifndef FMB_RULE_PARALLEL_H
#define FMB_RULE_PARALLEL_H

#include "rule/rule_private.h"

/* Of live inequalities whose first `entries` entries are positive multiples of each other, mark all
 * but the one with the least bound at equal scale; of equal bounds a strict one is kept. */
fmb_status fmb_parallel_drop(const fmb_view *w, int entries, bool *drop);

#endif
