/* substituted_rows.h: which rows the others imply (lp/redundancy/active_set/implied.h), where some
 * are equalities.
 *
 * With equalities there is no strictly interior point, from which most irredundant rows are found.
 * So each equality substitutes a variable in all other rows. Inequalities remain; they have an
 * interior point unless some of them are implicit equalities. */
#ifndef FMB_SOLVE_SUBSTITUTED_ROWS_H
#define FMB_SOLVE_SUBSTITUTED_ROWS_H

#include "base/arena.h"
#include "lp/redundancy/active_set/implied.h"
#include "num/vec.h"

/* As fmb_lp_sort_rows, without pauses. An equality is redundant if it follows from those before it.
 * out->inner satisfies the equalities. tight[m], all false: gets true for implicit equalities,
 * which are kept as equalities; NULL: they stay inequalities. num is for n + 1 entries. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_substituted_rows_sort(fmb_run *run, fmb_arena *arena, fmb_num *num, size_t n,
                                     size_t m, const fmb_lp_row *row, fmb_sorting *out,
                                     bool *tight);

#endif
