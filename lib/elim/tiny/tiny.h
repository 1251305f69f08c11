/* tiny.h: feasibility of tiny systems: elimination on the stack, without any allocation. */
#ifndef FMB_ELIM_TINY_H
#define FMB_ELIM_TINY_H

#include <fmb/solve.h>

#include "num/vec.h"

/* FMB_FEASIBLE or FMB_INFEASIBLE, both exact; or FMB_UNKNOWN if s is too large, has an equality, or
 * needs more rows or larger numbers than the tables hold. The elimination is the engine's with the
 * rules kohler and box, order pairs and all steps; its rounds, pairs and rows are counted in
 * *stats. Needs 40 KB of stack. */
fmb_verdict fmb_tiny_decide(const fmb_system *s, fmb_stats *stats);

/* For m small rows a.x <= b over n columns, none of them constant: FMB_FEASIBLE if a point
 * satisfies all of them strictly; FMB_INFEASIBLE if none does, and then *tight is the set of rows
 * in a combination with positive multipliers that is 0 <= 0, so that they are implicit equalities,
 * or 0 <= b < 0. FMB_UNKNOWN as above. */
fmb_verdict fmb_tiny_find_tight(size_t n, size_t m, const fmb_vec *row, uint64_t *tight);

#endif
