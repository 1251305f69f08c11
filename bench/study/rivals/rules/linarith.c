/* linarith.c: both tests of Lean's linarith, on histories and on equal rows. NOT SOUND.
 *
 * linarith keeps its rows in a set, which holds the first of several equal rows, and drops rows
 * that are not minimal by Imbert's first theorem. Each test is sound by itself. Together they are
 * not: the kept one of two equal rows may have a larger history than the dropped one, and its
 * descendants exceed Imbert's bound, while those of the dropped row, which would replace them, were
 * never formed. linarith then misses a proof. Its authors promise only correct proofs; it is no
 * decision procedure. Here rows are compared without their common divisor, so multiples are equal,
 * unlike there; and the rule is not flagged as breaking histories, or the engine would repair the
 * fault. Source: Mathlib, Mathlib/Tactic/Linarith/Oracle/FourierMotzkin.lean (R. Y. Lewis, 2020).
 */
#include "study/rivals/rules/rivals.h"

#include <string.h>

static bool drop_row_of_long_history(void *state, const fmb_view *w, size_t row)
{
    (void)state;
    return rival_imbert_exceeds(w, row);
}

static bool is_same_row(const fmb_view *w, size_t a, size_t b)
{
    const int64_t *u = fmb_view_int64(w, a), *v = fmb_view_int64(w, b);
    return u && v && fmb_view_rel(w, a) == fmb_view_rel(w, b) &&
           memcmp(u, v, ((size_t)fmb_view_dim(w) + 1) * sizeof *u) == 0;
}

static fmb_status drop_equal_rows(void *state, const fmb_view *w, bool *drop)
{
    size_t rows = fmb_view_rows(w);
    (void)state;
    for (size_t i = 0; i < rows; i++)
        for (size_t k = i + 1; !drop[i] && k < rows; k++)
            if (is_same_row(w, fmb_view_row(w, i), fmb_view_row(w, k)))
                drop[k] = true;
    return FMB_OK;
}

const fmb_rule rival_linarith = {
    .name = "linarith",
    .source = "Mathlib2020",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .drop_row = drop_row_of_long_history,
    .end_round = drop_equal_rows,
};
