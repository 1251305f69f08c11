/* rule_lp.h: the rule "lp": redundancy by exact linear programs while eliminating. */
#ifndef FMB_SOLVE_RULE_LP_H
#define FMB_SOLVE_RULE_LP_H

#include <fmb/rule.h>

/* For systems that are known to be feasible. It tests the rows when their number has doubled since
 * the last test, and whenever it is called between rounds. */
extern const fmb_rule fmb_rule_lp;

#endif
