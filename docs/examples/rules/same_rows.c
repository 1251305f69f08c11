/* same_rows.c: a pruning rule of one's own: of rows with the same coefficients the tightest stays.
 *
 * a.x <= b goes where a.x <= c is there with c <= b; of equal rows the first stays.
 */
#include "same_rows.h"

#include <string.h>

/* Is the row with entries u, as bounds go, at least as tight as the one with entries v? */
static bool is_tighter(const int64_t *u, bool u_strict, const int64_t *v, bool v_strict, int n)
{
    if (memcmp(u, v, (size_t)n * sizeof *u) != 0)
        return false;
    return u[n] < v[n] || (u[n] == v[n] && (u_strict || !v_strict));
}

/* Does the i-th live row make the k-th superfluous? Rows of large numbers are left alone. */
static bool beats(const fmb_view *w, size_t i, size_t k)
{
    size_t a = fmb_view_row(w, i), b = fmb_view_row(w, k);
    const int64_t *u = fmb_view_int64(w, a), *v = fmb_view_int64(w, b);
    bool u_strict = fmb_view_rel(w, a) == FMB_LT, v_strict = fmb_view_rel(w, b) == FMB_LT;
    if (!u || !v || fmb_view_rel(w, a) == FMB_EQ || fmb_view_rel(w, b) == FMB_EQ)
        return false;
    return is_tighter(u, u_strict, v, v_strict, fmb_view_dim(w));
}

static fmb_status end_round(void *state, const fmb_view *w, bool *drop)
{
    size_t rows = fmb_view_rows(w);
    (void)state;
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; !drop[i] && k < rows; k++)
            if (k != i && beats(w, i, k))
                drop[k] = true;
    return FMB_OK;
}

const fmb_rule same_rows = {
    .name = "same-rows",
    .source = "docs/adding-a-rule.md",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .end_round = end_round,
};
