/* prune_lp.h: the rule "lp": live rows that the others imply go, once there are many. */
#ifndef FMB_SOLVE_PRUNE_LP_H
#define FMB_SOLVE_PRUNE_LP_H

#include "rule/rule.h"
#include "trace/run.h"

typedef struct fmb_prune_lp {
    fmb_run *run;
    bool wide_only;
    size_t next; /* live rows from which the rule acts: twice what the last time left */
} fmb_prune_lp;

/* The rule, with its state (borrowed). */
fmb_rule fmb_prune_lp_rule(fmb_prune_lp *state);

#endif
