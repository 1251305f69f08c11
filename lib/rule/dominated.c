/* dominated.c: keeps the tightest of parallel rows that bound the same side.
 *
 * The article's rule for parallel rows, in n variables: a.x <= b is dropped if there is a row s a.x
 * <= c with s > 0 and c / s <= b (of equal bounds a strict one is kept). Source: Baillehache 2020.
 *
 * A number to check: x + y <= 1, 2 x + 2 y <= 3, -x - y <= 0: two rows remain.
 */
#include "rule/parallel.h"

static fmb_status mark_dominated_rows(void *state, const fmb_view *w, bool *drop)
{
    (void)state;
    return fmb_parallel_drop(w, fmb_view_dim(w), drop);
}

const fmb_rule fmb_rule_dominated = {
    .name = "dominated",
    .source = "Baillehache2020",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .end_round = mark_dominated_rows,
};
