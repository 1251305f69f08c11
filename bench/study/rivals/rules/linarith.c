/* linarith.c: what Lean's linarith drops, histories and equal rows at once. NOT SOUND.
 *
 * linarith keeps its rows in a set in which two rows with the same form are one, the first to come,
 * and drops those that Imbert's first theorem calls not minimal. Each is sound by itself. Together
 * they are not: the row that stays of two equal ones may have a larger history than the one that
 * went, and its descendants fall to Imbert's bound although those that would have taken their place
 * were never made. linarith then fails to prove what it could. Its authors promise no more than
 * proofs that are right; as a procedure that decides it goes wrong. Here rows have no common
 * divisor when they are compared, so a multiple is equal, too, which it is not there; and the flag
 * of a rule that breaks histories is left out, or the engine would mend it. Source: Mathlib,
 * Mathlib/Tactic/Linarith/Oracle/FourierMotzkin.lean (R. Y. Lewis, 2020).
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
