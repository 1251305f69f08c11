/* squeeze.c: the end of an elimination: one variable remains, and each row is a bound on it.
 *
 * Pairing all lower with all upper bounds would only make constant rows; the largest lower and the
 * least upper bound (of equal bounds a strict one) clash if any pair does. So one comparison for
 * each row and one combination suffice.
 */
#include "elim/round/round.h"

/* Sign of b_x |a_y| - b_y |a_x|: the order of the bounds b / |a| that rows x and y put on var,
 * times the sign of their coefficients. */
static int compare_bounds(const fmb_elim *e, uint32_t x, uint32_t y, size_t var)
{
    const fmb_vec *u = &e->row[x].v, *v = &e->row[y].v;
    return fmb_vec_compare_products(u, (size_t)e->n, v, var, v, (size_t)e->n, u, var);
}

/* The row of the least b / |a| among row[from..to): the tightest bound of its side. */
static uint32_t find_tightest_bound(const fmb_elim *e, const fmb_round *round, size_t from,
                                    size_t to)
{
    uint32_t best = round->row[from];
    for (size_t i = from + 1; i < to; i++) {
        uint32_t r = round->row[i];
        int order = compare_bounds(e, r, best, (size_t)round->var);
        if (order < 0 || (order == 0 && e->row[r].strict && !e->row[best].strict))
            best = r;
    }
    return best;
}

fmb_status fmb_elim_squeeze(fmb_elim *e, const fmb_round *round, size_t lowers)
{
    uint32_t p = find_tightest_bound(e, round, 0, lowers);
    uint32_t q = find_tightest_bound(e, round, lowers, round->rows);
    e->run->stats.pairs++;
    return fmb_elim_combine(e, p, q, round->var);
}
