/* expand.c: expansion of a shared linear term over the variables; see linear.h.
 *
 * All nodes reachable from the term are collected and visited from the latest to the earliest: then
 * the factor of a node is complete when it is visited, and each node is visited once, however often
 * it is shared.
 */
#include <stdlib.h>

#include "io/smt2/linear.h"

static int compare_latest_first(const void *x, const void *y)
{
    uint32_t a = *(const uint32_t *)x, b = *(const uint32_t *)y;
    return (a < b) - (a > b);
}

static fmb_status mark_as_reached(fmb_lin *l, uint32_t node, size_t *n)
{
    if (l->node[node].stamp == l->stamp)
        return FMB_OK;
    FMB_TRY(FMB_RESERVE(l->c->mem, &l->reached, &l->reached_capacity, *n + 1));
    l->node[node].stamp = l->stamp;
    l->reached[(*n)++] = node;
    return FMB_OK;
}

static fmb_status reserve_factors(fmb_lin *l, size_t n)
{
    size_t capacity = l->factors;
    fmb_status st = FMB_RESERVE(l->c->mem, &l->factor, &capacity, n);
    for (; l->factors < capacity; l->factors++)
        mpq_init(l->factor[l->factors]);
    return st;
}

/* reached[0..*n): the node and all below it, latest first, with their factors set to zero. */
static fmb_status collect_reached_nodes(fmb_lin *l, uint32_t node, size_t *n)
{
    *n = 0;
    l->stamp++;
    FMB_TRY(mark_as_reached(l, node, n));
    for (size_t i = 0; i < *n; i++) {
        const fmb_lin_node v = l->node[l->reached[i]];
        for (uint32_t k = 0; k < v.n; k++)
            FMB_TRY(mark_as_reached(l, l->term[v.first + k].leaf, n));
    }
    FMB_TRY(reserve_factors(l, *n));
    qsort(l->reached, *n, sizeof *l->reached, compare_latest_first);
    for (size_t i = 0; i < *n; i++) {
        l->node[l->reached[i]].place = (uint32_t)i;
        mpq_set_ui(l->factor[i], 0, 1);
    }
    return FMB_OK;
}

/* sum += a b. */
static fmb_status add_charged_product(fmb_lin *l, const char *at, mpq_ptr sum, mpq_srcptr a,
                                      mpq_srcptr b)
{
    mpq_mul(l->product, a, b);
    mpq_add(sum, sum, l->product);
    return fmb_io_charge(l->c, at, fmb_io_digits(sum));
}

/* Add the factor of the i-th reached node, a sum, to those of its leaves, and to -constant. */
static fmb_status hand_factor_to_leaves(fmb_lin *l, const char *at, size_t i,
                                        mpq_ptr minus_constant)
{
    const fmb_lin_node *v = &l->node[l->reached[i]];
    mpq_neg(l->factor[i], l->factor[i]);
    fmb_status st = add_charged_product(l, at, minus_constant, l->factor[i], v->constant);
    mpq_neg(l->factor[i], l->factor[i]);
    for (uint32_t k = 0; st == FMB_OK && k < v->n; k++) {
        const fmb_lin_term *t = &l->term[v->first + k];
        st = add_charged_product(l, at, l->factor[l->node[t->leaf].place], l->factor[i], t->coef);
    }
    return st;
}

fmb_status fmb_lin_expand(fmb_lin *l, const char *at, uint32_t node, fmb_draft *d)
{
    size_t n;
    FMB_TRY(collect_reached_nodes(l, node, &n));
    fmb_draft_reset(d);
    mpq_set_ui(l->factor[0], 1, 1);
    for (size_t i = 0; i < n; i++) {
        const fmb_lin_node *v = &l->node[l->reached[i]];
        if (mpq_sgn(l->factor[i]) == 0)
            continue;
        if (v->var < 0)
            FMB_TRY(hand_factor_to_leaves(l, at, i, d->rhs));
        else
            FMB_TRY(fmb_draft_add(d, v->var, l->factor[i]));
    }
    return FMB_OK;
}

/* Are all leaves variables? Then no terms can cancel. */
static bool has_only_variables(const fmb_lin *l, const fmb_lin_node *v)
{
    for (uint32_t k = 0; k < v->n; k++)
        if (l->node[l->term[v->first + k].leaf].var < 0)
            return false;
    return true;
}

fmb_status fmb_lin_constant(fmb_lin *l, const char *at, uint32_t node, bool *yes, mpq_t value)
{
    *yes = fmb_lin_is_bare(l, node);
    if (*yes)
        mpq_set(value, l->node[node].constant);
    if (*yes || has_only_variables(l, &l->node[node]))
        return FMB_OK;
    fmb_draft d;
    fmb_draft_init(&d, l->c->mem);
    fmb_status st = fmb_lin_expand(l, at, node, &d);
    if (st == FMB_OK && d.n == 0) {
        mpq_neg(value, d.rhs);
        *yes = true;
    }
    fmb_draft_clear(&d);
    return st;
}
