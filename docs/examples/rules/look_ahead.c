/* look_ahead.c: an order of one's own: the variable after which the next one is cheapest.
 *
 * Eliminating column c makes a row of each pair of rows with opposite signs in c, in place of all
 * rows that name c. What sign such a row has in another column is known unless its parents differ
 * there: then it is counted as half a row of either sign.
 */
#include "look_ahead.h"

typedef struct tally {
    double lower, upper; /* rows of negative and of positive coefficient */
} tally;

static void count(tally *t, int sign)
{
    t->lower += sign < 0;
    t->upper += sign > 0;
}

/* Rows made less rows gone. */
static double growth(tally t)
{
    return t.lower * t.upper - t.lower - t.upper;
}

/* Column d among the rows that there are when c is gone; c == d: among those there are now. */
static tally after(const fmb_view *w, int c, int d)
{
    tally t = {0, 0};
    size_t rows = fmb_view_rows(w);
    for (size_t i = 0; i < rows; i++) {
        size_t a = fmb_view_row(w, i);
        int sign = fmb_view_sign(w, a, c), own = fmb_view_sign(w, a, d);
        if (sign == 0 || c == d)
            count(&t, own);
        for (size_t k = 0; sign < 0 && c != d && k < rows; k++) {
            size_t b = fmb_view_row(w, k);
            int other = fmb_view_sign(w, b, d);
            if (fmb_view_sign(w, b, c) > 0 && own * other < 0)
                t = (tally){t.lower + 0.5, t.upper + 0.5};
            else if (fmb_view_sign(w, b, c) > 0)
                count(&t, own ? own : other);
        }
    }
    return t;
}

static int choose(void *self, const fmb_view *w, const int *col, size_t n)
{
    int best = col[0];
    double least = 0;
    (void)self;
    for (size_t i = 0; i < n; i++) {
        double now = growth(after(w, col[i], col[i])), next = 0;
        for (size_t k = 0, seen = 0; k < n; k++)
            if (k != i) {
                double then = growth(after(w, col[i], col[k]));
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
