/* substituted_rows.h: which rows the others imply (lp/redundancy/active_set/implied.h), where some
 * are equalities.
 *
 * Beside equalities there is no point strictly inside, from where most rows that stay are seen. So
 * each takes a variable out of all other rows; what is left are inequalities, which have one unless
 * some of them always hold with equality. */
#ifndef FMB_SOLVE_SUBSTITUTED_ROWS_H
#define FMB_SOLVE_SUBSTITUTED_ROWS_H

#include "base/arena.h"
#include "lp/redundancy/active_set/implied.h"
#include "num/vec.h"

/* As fmb_lp_sort_rows, without pauses; equalities are told from those before them: gone or kept.
 * out->inner: of a point that satisfies equalities. tight[m], false: inequalities that are found to
 * be equalities are kept as such; NULL: they stay what they are. num is for n + 1 entries. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_substituted_rows_sort(fmb_run *run, fmb_arena *arena, fmb_num *num, size_t n,
                                     size_t m, const fmb_lp_row *row, fmb_sorting *out,
                                     bool *tight);

#endif
