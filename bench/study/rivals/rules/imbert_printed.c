/* imbert_printed.c: the algorithm printed beside Imbert's theorems. NOT SOUND.
 *
 * The algorithm of section 6 finds the implicitly eliminated variables of a sum as the union of
 * those of its parents, less the effectively eliminated ones. They begin empty, so they stay empty
 * for ever (this was noticed in the source of Lean's linarith), and what is tested is |H| <= 1 +
 * |E|. A minimal row may have a larger history: variables that cancel by coincidence are not
 * counted, and so needed rows are dropped. Source: Imbert 1990, section 6, as linarith's authors
 * quote it; theorem 13 itself is right (imbert_first.c).
 */
#include "study/rivals/rules/rivals.h"

static bool drop_row_unless_effective(void *state, const fmb_view *w, size_t row)
{
    size_t words, columns;
    const uint64_t *history = fmb_view_history(w, row, &words);
    const uint64_t *effective = fmb_view_effective(w, row, &columns);
    (void)state;
    return history && rival_count(history, words) > 1 + rival_count(effective, columns);
}

const fmb_rule rival_imbert_printed = {
    .name = "imbert-printed",
    .source = "Imbert1990",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .drop_row = drop_row_unless_effective,
};
