/* look_ahead.c: an order of one's own: the variable after which the next one is cheapest.
 *
 * Eliminating column c makes a row of each pair of rows with opposite signs in c, in place of all
 * rows that name c. What sign such a row has in another column is known unless its parents differ
 * there: then it is counted as half a row of either sign.
 */
#include "look_ahead.h"

/* Rows added less rows removed by eliminating d after c; c == d: by eliminating it now. */
static double growth(const fmb_view *w, int c, int d)
{
    double lower = 0, upper = 0; /* rows of negative and of positive coefficient in d */
    size_t rows = fmb_view_rows(w);
    for (size_t i = 0; i < rows; i++) {
        size_t a = fmb_view_row(w, i);
        int sign = fmb_view_sign(w, a, c), own = fmb_view_sign(w, a, d);
        lower += (sign == 0 || c == d) && own < 0;
        upper += (sign == 0 || c == d) && own > 0;
        for (size_t k = 0; sign < 0 && c != d && k < rows; k++) {
            size_t b = fmb_view_row(w, k);
            int sum = own + fmb_view_sign(w, b, d);
            if (fmb_view_sign(w, b, c) <= 0)
                continue;
            lower += sum < 0 ? 1 : sum == 0 && own ? 0.5 : 0;
            upper += sum > 0 ? 1 : sum == 0 && own ? 0.5 : 0;
        }
    }
    return lower * upper - lower - upper;
}

static int choose(void *self, const fmb_view *w, const int *col, size_t n)
{
    int best = col[0];
    double least = 0;
    (void)self;
    for (size_t i = 0; i < n; i++) {
        double now = growth(w, col[i], col[i]), next = 0;
        for (size_t k = 0, seen = 0; k < n; k++)
            if (k != i) {
                double then = growth(w, col[i], col[k]);
                next = seen++ == 0 || then < next ? then : next;
            }
        if (i == 0 || now + next < least) {
            best = col[i];
            least = now + next;
        }
    }
    return best;
}

const fmb_named_chooser look_ahead = {
    .name = "look-ahead", .source = "docs/adding-a-rule.md", .chooser = {.choose = choose}};
