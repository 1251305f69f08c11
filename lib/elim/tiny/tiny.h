/* tiny.h: is a tiny system feasible? Elimination on the stack, without any allocation. */
#ifndef FMB_ELIM_TINY_H
#define FMB_ELIM_TINY_H

#include <fmb/solve.h>

#include "num/vec.h"

/* FMB_FEASIBLE or FMB_INFEASIBLE, both exact; or FMB_UNKNOWN if s is too large, has an equality, or
 * needs more rows or larger numbers than there is room for. The elimination is the engine's with
 * rules kohler and box, order pairs and all steps; its rounds, pairs and rows are counted in
 * *stats. Needs 40 KB of stack. */
fmb_verdict fmb_tiny_decide(const fmb_system *s, fmb_stats *stats);

/* Of m small rows a.x <= b over n columns, each of which names some: FMB_FEASIBLE if a point is
 * strictly inside of all; FMB_INFEASIBLE if there is none, and then bit i of *tight tells whether
 * row i has a part in a sum of positive multiples of rows that says 0 <= 0, and is an equality
 * where they hold, or 0 <= b < 0. FMB_UNKNOWN as above. */
fmb_verdict fmb_tiny_find_tight(size_t n, size_t m, const fmb_vec *row, uint64_t *tight);

#endif
