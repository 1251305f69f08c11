/* chernikov_sets.c: Chernikov's rule as published, applied to the formed rows of a round.
 *
 * A live row is dropped if its history strictly contains that of another; of equal histories the
 * first row is kept. Trivial rows (0 <= 3) are not live, so a row may be kept that the library's
 * `chernikov` does not form, as it keeps all histories and tests pairs first. A dropped row is no
 * extreme ray of the cone of combinations, or a duplicate: the proof of lib/rule/chernikov.c holds
 * for each set by itself. Source: Chernikov 1960.
 *
 * A number to check: of |x1| + ... + |x4| <= 1, written as 16 rows, three rounds leave 28 rows.
 */
#include "study/rivals/rules/rivals.h"

static bool is_subset(const uint64_t *a, const uint64_t *b, size_t words)
{
    for (size_t k = 0; k < words; k++)
        if (a[k] & ~b[k])
            return false;
    return true;
}

static fmb_status drop_larger_histories(void *state, const fmb_view *w, bool *drop)
{
    size_t rows = fmb_view_rows(w), words;
    (void)state;
    for (size_t i = 0; i < rows && !fmb_view_stop(w); i++) {
        const uint64_t *inner = fmb_view_history(w, fmb_view_row(w, i), &words);
        for (size_t k = 0; inner && !drop[i] && k < rows; k++) {
            const uint64_t *outer = fmb_view_history(w, fmb_view_row(w, k), &words);
            if (k != i && is_subset(inner, outer, words))
                drop[k] = true;
        }
    }
    return FMB_OK;
}

const fmb_rule rival_chernikov_sets = {
    .name = "chernikov-sets",
    .source = "Chernikov1960",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .end_round = drop_larger_histories,
};
