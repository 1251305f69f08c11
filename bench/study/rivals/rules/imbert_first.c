/* imbert_first.c: Imbert's first acceleration theorem alone.
 *
 * With H the history of a row, E the variables effectively eliminated on the way to it, I those
 * implicitly eliminated and O all that are eliminated: a minimal row has |H| <= 1 + |E u (I n O)|,
 * so rows with larger histories are dropped. As this is an upper bound only, other rows that are
 * not minimal are kept; it drops all that Kohler's rule drops, as E and I n O are subsets of O. The
 * theorem that spares the comparison, |H| = 1 + |E|, and the comparison itself are the library's
 * rule `imbert`. Source: Imbert 1990, theorem 13 (doi 10.1016/B978-0-444-88771-9.50019-2).
 *
 * A number to check: of |x1| + ... + |x4| <= 1, written as 16 rows, three rounds leave 48 rows, as
 * many as Kohler's rule, and 28 with the second theorem and the comparison (`imbert`).
 */
#include "study/rivals/rules/rivals.h"

bool rival_imbert_exceeds(const fmb_view *w, size_t row)
{
    size_t words, columns;
    const uint64_t *history = fmb_view_history(w, row, &words);
    const uint64_t *effective = fmb_view_effective(w, row, &columns);
    const uint64_t *gone = fmb_view_gone(w);
    uint64_t *out = fmb_view_scratch(w, columns * sizeof *out);
    if (!history || !out)
        return false;
    fmb_view_implicit(w, row, out);
    for (size_t k = 0; k < columns; k++)
        out[k] = effective[k] | (out[k] & gone[k]);
    return rival_count(history, words) > 1 + rival_count(out, columns);
}

static bool drop_row_of_long_history(void *state, const fmb_view *w, size_t row)
{
    (void)state;
    return rival_imbert_exceeds(w, row);
}

const fmb_rule rival_imbert_first = {
    .name = "imbert-first",
    .source = "Imbert1990",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .drop_row = drop_row_of_long_history,
};
