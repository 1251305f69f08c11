/* tiny.h: is a tiny system feasible? Elimination on the stack, without any allocation. */
#ifndef FMB_ELIM_TINY_H
#define FMB_ELIM_TINY_H

#include <fmb/solve.h>

/* FMB_FEASIBLE or FMB_INFEASIBLE, both exact; or FMB_UNKNOWN if s is too large, has an equality, or
 * needs more rows or larger numbers than there is room for. The elimination is the engine's with
 * rules kohler and box, order pairs and all steps; its rounds, pairs and rows are counted in
 * *stats. Needs 40 KB of stack. */
fmb_verdict fmb_tiny_decide(const fmb_system *s, fmb_stats *stats);

#endif
