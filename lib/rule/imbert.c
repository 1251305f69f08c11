/* imbert.c: Imbert's two acceleration theorems, and the rank test where they do not decide.
 *
 * Let H be the history of a row, O the variables eliminated since the base, E those effectively
 * eliminated on the way to the row (some combination cancelled them), and I those implicitly
 * eliminated: in a base row of H, but neither in the row nor in E. I is computed anew from the base
 * rows; the union of the parents' is wrong. A row is minimal if no other combination uses only rows
 * of H, and only minimal rows are needed.
 *   Theorem 1: a minimal row has 1 + |E| <= |H| <= 1 + |E u (I n O)|.
 *   Theorem 2: if |H| = 1 + |E|, the row is minimal.
 * Between the two bounds, it is minimal if and only if the base rows of H have rank |H| - 1 in the
 * columns O. Kohler's bound, |H| <= 1 + |O|, follows from the first, and is used before the row is
 * made. Proofs: docs/theory.md, theorem 13. Source: Imbert 1990, 1993 (docs/references.bib).
 *
 * A number to check: the 28 rows of chernikov.c.
 */
#include "rule/rule_private.h"

static int count_elements(const uint64_t *set, size_t words)
{
    int n = 0;
    for (size_t k = 0; k < words; k++)
        n += __builtin_popcountll(set[k]);
    return n;
}

/* |E u (I n O)|: E lies in O. */
static int count_possibly_eliminated(const fmb_view *w, size_t row, const uint64_t *effective,
                                     size_t words)
{
    uint64_t *implicit = fmb_view_scratch(w, words * sizeof *implicit);
    const uint64_t *gone = fmb_view_gone(w);
    if (!implicit)
        return fmb_view_eliminated(w);
    fmb_view_implicit(w, row, implicit);
    for (size_t k = 0; k < words; k++)
        implicit[k] = effective[k] | (implicit[k] & gone[k]);
    return count_elements(implicit, words);
}

static bool drop_row_unless_minimal(void *state, const fmb_view *w, size_t row)
{
    size_t words, columns;
    const uint64_t *history = fmb_view_history(w, row, &words);
    const uint64_t *effective = fmb_view_effective(w, row, &columns);
    (void)state;
    int size = count_elements(history, words);
    if (size == 1 + count_elements(effective, columns))
        return false;
    if (size > 1 + count_possibly_eliminated(w, row, effective, columns))
        return true;
    return !fmb_view_minimal(w, row);
}

const fmb_rule fmb_rule_imbert = {
    .name = "imbert",
    .source = "Imbert1993",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .drop_pairs = fmb_kohler_drop_pairs,
    .drop_row = drop_row_unless_minimal,
};
