/* near_duplicate_names.c: names that occur in a .fmb text once and look like a misspelling of
 * another name: mlik for milk.
 *
 * Where a vars line declares the names, a misspelling is an error; elsewhere it is a new variable,
 * and the answer is about another system. A misspelling has a letter too many, too few, wrong, or
 * swapped with its neighbour (Damerau 1964). Not reported are names that differ in digits (x1, x2)
 * or in a letter used as an index (dist_a, dist_b, flow_ab, flow_ba), and very short ones; nor any
 * if many names look alike, as they then follow a scheme.
 */
#include <string.h>

#include "io/core/cursor.h"
#include "io/text/text.h"

enum { SHORTEST = 4, MOST_NAMES = 1000 };

static bool is_ascii_letter(int b)
{
    return (b | 32) >= 'a' && (b | 32) <= 'z';
}

/* Is a one misspelling away from b? b occurs `often`, or only once. */
static bool is_one_slip_apart(const char *a, const char *b, bool often)
{
    size_t m = strlen(a), n = strlen(b), from = 0, behind = 0;
    if (m + n < 2 * SHORTEST - 1 || m > n + 1 || n > m + 1)
        return false;
    while (from < m && from < n && a[from] == b[from])
        from++;
    while (behind < m - from && behind < n - from && a[m - 1 - behind] == b[n - 1 - behind])
        behind++;
    size_t p = m - from - behind, q = n - from - behind;
    for (size_t k = 0; k < p + q; k++)
        if (fmb_is_digit(k < p ? a[from + k] : b[from + k - p]))
            return false;
    bool left = from > 0 && is_ascii_letter(a[from - 1]);
    bool right = behind > 0 && is_ascii_letter(a[m - behind]);
    if (p == 1 && q == 1)
        return often && left && right;
    return p + q == 1 || (p == 2 && q == 2 && a[from] == b[from + 1] && a[from + 1] == b[from] &&
                          (left || right));
}

/* The variable that j, which occurs once, may be a misspelling of, or -1. If both occur once, the
 * second is the misspelling. */
static int find_near_duplicate(const fmb_text *t, int j)
{
    const char *name = fmb_system_name(t->s, j);
    for (int i = 0; i < fmb_system_dim(t->s); i++) {
        bool often = t->use[i].times > 1;
        if (i != j && (often || i < j) && is_one_slip_apart(name, fmb_system_name(t->s, i), often))
            return i;
    }
    return -1;
}

void fmb_text_warn_of_near_duplicates(const fmb_text *t)
{
    int dim = fmb_system_dim(t->s), slips = 0;
    if (t->declared || dim > MOST_NAMES || !t->c->how->warn)
        return;
    for (int j = 0; j < dim; j++) {
        t->use[j].near_duplicate = t->use[j].times == 1 ? find_near_duplicate(t, j) : -1;
        slips += t->use[j].near_duplicate >= 0;
    }
    for (int j = 0; j < dim && slips <= 1 + dim / 4; j++) {
        char found[FMB_QUOTE], meant[FMB_QUOTE];
        int i = t->use[j].near_duplicate;
        if (i >= 0)
            fmb_io_warn(t->c, t->use[j].at, "%s stands here only; did you mean %s?",
                        fmb_quote_name(fmb_system_name(t->s, j), found),
                        fmb_quote_name(fmb_system_name(t->s, i), meant));
    }
}
