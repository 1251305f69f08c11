/* rule_lp.h: the rule "lp": redundancy by exact linear programs while eliminating. */
#ifndef FMB_SOLVE_RULE_LP_H
#define FMB_SOLVE_RULE_LP_H

#include <fmb/rule.h>

/* For systems that are known to be feasible. It looks at the rows when they have doubled since it
 * looked last, and whenever it is asked between rounds. */
extern const fmb_rule fmb_rule_lp;

#endif
