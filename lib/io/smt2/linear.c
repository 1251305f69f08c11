/* linear.c: making linear terms; see linear.h. */
#include "io/smt2/linear.h"

#include <stdlib.h>
#include <string.h>

void fmb_lin_init(fmb_lin *l, fmb_cursor *c)
{
    *l = (fmb_lin){.c = c};
    mpq_init(l->sum.constant);
    mpq_init(l->product);
}

void fmb_lin_clear(fmb_lin *l)
{
    fmb_mem *mem = l->c->mem;
    fmb_lin_forget(l, 0);
    for (size_t k = 0; k < l->sum.capacity; k++)
        mpq_clear(l->sum.term[k].coef);
    for (size_t k = 0; k < l->factors; k++)
        mpq_clear(l->factor[k]);
    mpq_clear(l->sum.constant);
    mpq_clear(l->product);
    fmb_mem_put(mem, l->sum.term, l->sum.capacity, sizeof *l->sum.term);
    fmb_mem_put(mem, l->node, l->node_capacity, sizeof *l->node);
    fmb_mem_put(mem, l->term, l->term_capacity, sizeof *l->term);
    fmb_mem_put(mem, l->reached, l->reached_capacity, sizeof *l->reached);
    fmb_mem_put(mem, l->factor, l->factors, sizeof *l->factor);
}

void fmb_lin_forget(fmb_lin *l, size_t nodes)
{
    for (; l->nodes > nodes; l->nodes--) {
        fmb_lin_node *v = &l->node[l->nodes - 1];
        mpq_clear(v->constant);
        for (uint32_t k = 0; k < v->n; k++)
            mpq_clear(l->term[v->first + k].coef);
        l->terms -= v->n;
    }
}

/* An empty sum as a new node. */
static fmb_status new_linear_node(fmb_lin *l, int var, uint32_t *out)
{
    if (l->nodes >= UINT32_MAX)
        return FMB_ERR_MEMORY;
    FMB_TRY(FMB_RESERVE(l->c->mem, &l->node, &l->node_capacity, l->nodes + 1));
    fmb_lin_node *v = &l->node[l->nodes];
    *v = (fmb_lin_node){.var = var, .first = l->terms};
    mpq_init(v->constant);
    *out = (uint32_t)l->nodes++;
    return FMB_OK;
}

fmb_status fmb_lin_variable(fmb_lin *l, int var, uint32_t *out)
{
    return new_linear_node(l, var, out);
}

fmb_status fmb_lin_number(fmb_lin *l, mpq_t value, uint32_t *out)
{
    FMB_TRY(new_linear_node(l, -1, out));
    mpq_swap(l->node[*out].constant, value);
    return FMB_OK;
}

/* ---- sums ------------------------------------------------------------------------------------ */

void fmb_lin_begin(fmb_lin *l)
{
    l->sum.n = l->sum.tidy = 0;
    mpq_set_ui(l->sum.constant, 0, 1);
}

static int compare_by_leaf(const void *x, const void *y)
{
    uint32_t a = ((const fmb_lin_term *)x)->leaf, b = ((const fmb_lin_term *)y)->leaf;
    return (a > b) - (a < b);
}

/* Sort the terms, add up equal leaves and drop zeros. */
static fmb_status merge_equal_leaves(fmb_lin *l, const char *at)
{
    fmb_lin_sum *s = &l->sum;
    fmb_status st = FMB_OK;
    size_t n = 0;
    if (s->n > 1)
        qsort(s->term, s->n, sizeof *s->term, compare_by_leaf);
    for (size_t k = 0; k < s->n; k++) {
        fmb_lin_term *t = &s->term[k];
        if (n > 0 && s->term[n - 1].leaf == t->leaf) {
            mpq_ptr into = s->term[n - 1].coef;
            mpq_add(into, into, t->coef);
            FMB_THEN(st, fmb_io_charge(l->c, at, fmb_io_digits(into)));
        } else {
            n -= n > 0 && mpq_sgn(s->term[n - 1].coef) == 0;
            s->term[n].leaf = t->leaf;
            if (n != k)
                mpq_swap(s->term[n].coef, t->coef);
            n++;
        }
    }
    n -= n > 0 && mpq_sgn(s->term[n - 1].coef) == 0;
    s->n = s->tidy = n;
    return st;
}

/* Make room for one more term. Combining like terms whenever the terms have doubled keeps their
 * number near that of different leaves, at the cost of an occasional sort. */
static fmb_status open_sum_term(fmb_lin *l, const char *at, uint32_t leaf, mpq_ptr *slot)
{
    fmb_lin_sum *s = &l->sum;
    size_t old = s->capacity;
    fmb_status st = FMB_OK;
    if (s->n >= 2 * s->tidy + 2 * FMB_LIN_SHORT)
        st = merge_equal_leaves(l, at);
    FMB_THEN(st, FMB_RESERVE(l->c->mem, &s->term, &s->capacity, s->n + 1));
    for (size_t k = old; k < s->capacity; k++)
        mpq_init(s->term[k].coef);
    if (st != FMB_OK)
        return st;
    s->term[s->n].leaf = leaf;
    *slot = s->term[s->n++].coef;
    return FMB_OK;
}

/* into = a b, charged to the budget. */
static fmb_status multiply_charged(fmb_lin *l, const char *at, mpq_ptr into, mpq_srcptr a,
                                   mpq_srcptr b)
{
    mpq_mul(into, a, b);
    return fmb_io_charge(l->c, at, fmb_io_digits(into));
}

fmb_status fmb_lin_add(fmb_lin *l, const char *at, uint32_t node, mpq_srcptr factor)
{
    fmb_lin_node *v = &l->node[node];
    mpq_ptr slot;
    if (mpq_sgn(factor) == 0)
        return FMB_OK;
    if (v->var >= 0 || v->n > FMB_LIN_SHORT) {
        FMB_TRY(open_sum_term(l, at, node, &slot));
        mpq_set(slot, factor);
        return FMB_OK;
    }
    FMB_TRY(multiply_charged(l, at, l->product, v->constant, factor));
    mpq_add(l->sum.constant, l->sum.constant, l->product);
    FMB_TRY(fmb_io_charge(l->c, at, fmb_io_digits(l->sum.constant)));
    for (uint32_t k = 0; k < v->n; k++) {
        fmb_lin_term *t = &l->term[v->first + k];
        FMB_TRY(open_sum_term(l, at, t->leaf, &slot));
        FMB_TRY(multiply_charged(l, at, slot, t->coef, factor));
    }
    return FMB_OK;
}

/* Is the sum just one node, with coefficient 1 and no constant? */
static bool is_single_node(const fmb_lin_sum *s)
{
    return s->n == 1 && mpq_sgn(s->constant) == 0 && mpq_cmp_ui(s->term[0].coef, 1, 1) == 0;
}

fmb_status fmb_lin_end(fmb_lin *l, uint32_t *out)
{
    fmb_lin_sum *s = &l->sum;
    FMB_TRY(merge_equal_leaves(l, l->c->at));
    if (is_single_node(s)) {
        *out = s->term[0].leaf;
        return FMB_OK;
    }
    FMB_TRY(FMB_RESERVE(l->c->mem, &l->term, &l->term_capacity, l->terms + s->n));
    FMB_TRY(new_linear_node(l, -1, out));
    fmb_lin_node *v = &l->node[*out];
    mpq_swap(v->constant, s->constant);
    for (size_t k = 0; k < s->n; k++) {
        fmb_lin_term *t = &l->term[l->terms++];
        t->leaf = s->term[k].leaf;
        mpq_init(t->coef);
        mpq_swap(t->coef, s->term[k].coef);
    }
    v->n = (uint32_t)s->n;
    return FMB_OK;
}
