/* duplicate.c: keeps one of rows that are equal up to positive scaling.
 *
 * A strict row implies its non-strict copy, so a strict one is kept if there is one. The choice has
 * nothing to do with histories: the dropped row may be the one whose combinations histories rely
 * on. Source: Fourier 1827.
 *
 * A number to check: x + y <= 1, 2 x + 2 y <= 2, x + y < 1: one row remains, the strict one.
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
