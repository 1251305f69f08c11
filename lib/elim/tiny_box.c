/* tiny_box.c: rows over the box of a tiny elimination; see rule/box.c and box.c for why.
 *
 * A sum of 7 products of numbers below 2^62 is below 2^127.
 */
#include "elim/tiny_inside.h"

fmb_tiny_step fmb_tiny_judge(const fmb_tiny *t, const fmb_tiny_table *rows, int i)
{
    const int64_t *a = rows->a[i];
    unsigned no_most = 0, no_least = 0; /* the box is open where a.x is greatest, least */
    fmb_i128 most = 0, least = 0;
    for (int k = 1; k <= t->n; k++) {
        if (a[k] == 0)
            continue;
        int up = a[k] > 0;
        no_most |= t->open[up] >> k & 1;
        no_least |= t->open[!up] >> k & 1;
        most += (fmb_i128)a[k] * t->end[up][k];
        least += (fmb_i128)a[k] * t->end[!up][k];
    }
    if (!no_most && most < a[0])
        return FMB_TINY_SLACK;
    if (!no_least && (least > a[0] || (least == a[0] && rows->strict[i])))
        return FMB_TINY_CLASH;
    return FMB_TINY_GO;
}
