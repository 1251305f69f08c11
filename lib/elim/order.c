/* order.c: which variable goes next. A variant is a cost function; the least cost wins, ties go to
 * the lower index.
 *
 * Whatever the order, a variable in an equality goes first (substitution adds no rows), then one
 * whose column has one sign only (its rows just go).
 */
#include <string.h>

#include "elim/elim.h"

/* What a column looks like among the live rows. */
typedef struct column {
    size_t lower, upper;           /* rows of negative, positive coefficient */
    size_t lower_size, upper_size; /* nonzeros in them */
    bool in_equality;
} column;

static size_t nonzeros(const fmb_elim *e, const fmb_derived *r)
{
    size_t count = 0;
    for (int j = 0; j < e->n; j++)
        count += fmb_vec_sgn(&r->v, (size_t)j) != 0;
    return count;
}

static column look(const fmb_elim *e, int var)
{
    column c = {0};
    bool fill = e->order == FMB_ORDER_FILL;
    for (size_t i = 0; i < e->lives; i++) {
        const fmb_derived *r = &e->row[e->live[i]];
        int sign = fmb_vec_sgn(&r->v, (size_t)var);
        if (sign == 0)
            continue;
        c.in_equality |= r->equality;
        size_t size = fill ? nonzeros(e, r) : 0;
        *(sign < 0 ? &c.lower : &c.upper) += 1;
        *(sign < 0 ? &c.lower_size : &c.upper_size) += size;
    }
    return c;
}

static double pairs_cost(const column *c)
{
    double p = (double)c->lower, q = (double)c->upper;
    return p * q - p - q;
}

static double given_cost(const column *c)
{
    (void)c;
    return 0;
}

static double min_cost(const column *c)
{
    return (double)(c->lower < c->upper ? c->lower : c->upper);
}

/* Nonzeros of all combinations, were there no overlap. */
static double fill_cost(const column *c)
{
    return (double)c->lower * (double)c->upper_size + (double)c->upper * (double)c->lower_size;
}

static double (*const COST[])(const column *) = {
    [FMB_ORDER_PAIRS] = pairs_cost,
    [FMB_ORDER_GIVEN] = given_cost,
    [FMB_ORDER_MIN] = min_cost,
    [FMB_ORDER_FILL] = fill_cost,
};

static bool is_done(const fmb_elim *e, int var)
{
    for (int i = 0; i < e->rounds; i++)
        if (e->round[i].var == var)
            return true;
    return false;
}

int fmb_elim_choose(const fmb_elim *e, const bool *drop)
{
    int best = -1, best_class = 0;
    double best_cost = 0;
    for (int j = 0; j < e->n; j++) {
        if (!drop[j] || is_done(e, j))
            continue;
        column c = look(e, j);
        int class = c.in_equality ? 0 : c.lower == 0 || c.upper == 0 ? 1 : 2;
        double cost = COST[e->order](&c);
        if (best < 0 || class < best_class || (class == best_class && cost < best_cost)) {
            best = j;
            best_class = class;
            best_cost = cost;
        }
    }
    return best;
}
