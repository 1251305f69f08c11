/* quasi_syntactic.c: quasi-syntactic redundancy: of parallel rows the tightest is kept.
 *
 * A row is quasi-syntactically redundant if another has the same coefficients up to a positive
 * factor and is at least as tight. u and v are parallel if u_i v_j = u_j v_i for some i with u_i !=
 * 0 and all j, and they point the same way; then u.x <= b is at least as tight as v.x <= c if b
 * |v_i| <= c |u_i|. A dropped row follows from a kept row, not only from another dropped one. It is
 * the library's `dominated`, here with a loop over all pairs. Source: Lassez, Huynh, McAloon 1989;
 * in polyhedra by constraints alone: Fouilhe, Monniaux, Perin 2013.
 *
 * A number to check: of x + y <= 1, 2x + 2y <= 3, 3x + 3y < 3 one row stays, the strict one.
 */
#include "study/rivals/rules/rivals.h"

#include "num/int128.h"

/* The sign of u v - x y. */
static int compare_products(int64_t u, int64_t v, int64_t x, int64_t y)
{
    return fmb_i128_compare(fmb_i128_product(u, v), fmb_i128_product(x, y));
}

static int first_column(const int64_t *u, int n)
{
    for (int j = 0; j < n; j++)
        if (u[j] != 0)
            return j;
    return -1;
}

/* Are u and v, with u[i] != 0, parallel and of the same direction? */
static bool is_parallel(const int64_t *u, const int64_t *v, int n, int i)
{
    if ((u[i] > 0) != (v[i] > 0) || v[i] == 0)
        return false;
    for (int j = 0; j < n; j++)
        if (compare_products(u[i], v[j], v[i], u[j]) != 0)
            return false;
    return true;
}

/* Is row a parallel to row b and at least as tight? False for rows of large numbers. */
static bool is_tighter(const fmb_view *w, size_t a, size_t b)
{
    int n = fmb_view_dim(w);
    const int64_t *u = fmb_view_int64(w, a), *v = fmb_view_int64(w, b);
    if (!u || !v || fmb_view_rel(w, a) == FMB_EQ || fmb_view_rel(w, b) == FMB_EQ)
        return false;
    int i = first_column(u, n);
    if (i < 0 || !is_parallel(u, v, n, i))
        return false;
    int order = compare_products(u[n], v[i], v[n], u[i]);
    if (u[i] < 0)
        order = -order;
    return order < 0 ||
           (order == 0 && (fmb_view_rel(w, a) == FMB_LT || fmb_view_rel(w, b) != FMB_LT));
}

static fmb_status drop_parallel_rows(void *state, const fmb_view *w, bool *drop)
{
    size_t rows = fmb_view_rows(w);
    (void)state;
    for (size_t i = 0; i < rows && !fmb_view_stop(w); i++)
        for (size_t k = 0; !drop[i] && k < rows; k++)
            if (k != i && !drop[k] && is_tighter(w, fmb_view_row(w, i), fmb_view_row(w, k)))
                drop[k] = true;
    return FMB_OK;
}

const fmb_rule rival_quasi_syntactic = {
    .name = "quasi-syntactic",
    .source = "LassezHuynhMcAloon1989",
    .flags = FMB_RULE_BREAKS_HISTORY,
    .end_round = drop_parallel_rows,
};
