/* duplicate.c: of rows that are equal up to positive scaling one stays.
 *
 * A strict row implies its copy that is not strict, so a strict one stays if there is one. Which
 * one stays has nothing to do with histories: the one that goes may be the one whose combinations
 * are counted on. Source: Fourier 1827.
 *
 * A number to check: x + y <= 1, 2 x + 2 y <= 2, x + y < 1: one row is left, the strict one.
 */
#include "rule/parallel.h"

static fmb_status mark_duplicate_rows(void *state, const fmb_view *w, bool *drop)
{
    (void)state;
    return fmb_parallel_drop(w, fmb_view_dim(w) + 1, drop);
}

const fmb_rule fmb_rule_duplicate = {
    .name = "duplicate",
    .source = "Fourier1827",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .end_round = mark_duplicate_rows,
};
