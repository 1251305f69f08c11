/* kohler.c: Kohler's rule.
 *
 * After k variables are eliminated, an irredundant row is a combination of at most k + 1 base rows.
 * For the multipliers of the rows that a round can make form the cone {y >= 0 : y A_k = 0}, A_k the
 * columns of the eliminated variables; only its extreme rays are needed, and the support of an
 * extreme ray has at most rank(A_k) + 1 <= k + 1 elements. The union of the parents' histories is
 * the history of the new row, so the test needs no arithmetic. Source: Kohler 1967, Projections of
 * convex polyhedral sets.
 */
#include "rule/rule.h"

static bool drop_pair(const fmb_view *w, const uint64_t *a, const uint64_t *b)
{
    int size = 0;
    for (size_t i = 0; i < w->words; i++)
        size += __builtin_popcountll(a[i] | b[i]);
    return size > w->eliminated + 1;
}

const fmb_rule fmb_rule_kohler = {
    .name = "kohler",
    .source = "Kohler1967",
    .flags = FMB_RULE_NEEDS_HISTORY,
    .drop_pair = drop_pair,
};
