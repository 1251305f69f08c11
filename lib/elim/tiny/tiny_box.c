/* tiny_box.c: rows over the box of a tiny elimination; see rule/box.c and rules/box_rule.c for why.
 *
 * A sum of 9 products of numbers below 2^62 and 2^60 is below 2^126.
 */
#include "elim/tiny/tiny_private.h"

/* The truth of a row over the box. */
typedef enum word { NOTHING, ALWAYS, NEVER } word;

static word check_row_over_box(fmb_tiny *t, const fmb_tiny_table *rows, int i)
{
    const int64_t *a = rows->a[i];
    uint64_t named = rows->history[i];  /* base rows, and those of a.x's least ends */
    unsigned no_most = 0, no_least = 0; /* the box is open where a.x is greatest, least */
    fmb_i128 most = fmb_i128_of(0), least = most, right = fmb_i128_of(a[0]);
    for (int k = 1; k <= t->n; k++) {
        if (a[k] == 0)
            continue;
        int up = a[k] > 0;
        no_most |= t->open[up] >> k & 1;
        no_least |= t->open[!up] >> k & 1;
        named |= t->end_history[!up][k];
        most = fmb_i128_plus_product(most, a[k], t->end[up][k]);
        least = fmb_i128_plus_product(least, a[k], t->end[!up][k]);
    }
    if (!no_most && fmb_i128_compare(most, right) < 0)
        return ALWAYS;
    int order = fmb_i128_compare(least, right);
    if (!no_least && (order > 0 || (order == 0 && rows->strict[i]))) {
        t->clash = named;
        return NEVER;
    }
    return NOTHING;
}

fmb_tiny_step fmb_tiny_prune(fmb_tiny *t, fmb_tiny_table *rows, int first)
{
    int left = first;
    for (int i = first; i < rows->rows; i++) {
        word said = check_row_over_box(t, rows, i);
        if (said == NEVER)
            return FMB_TINY_CLASH;
        if (said == ALWAYS)
            continue;
        if (left < i)
            fmb_tiny_copy(rows, left, rows, i);
        left++;
    }
    t->stats->rows_dropped += (uint64_t)(rows->rows - left);
    rows->rows = left;
    return FMB_TINY_GO;
}
