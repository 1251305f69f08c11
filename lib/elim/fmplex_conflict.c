/* fmplex_conflict.c: what a clash says about the nodes above it; the proof is in fmplex.c.
 *
 * A row made from p and the bound q of the node above is (alpha p + beta q) / content, where alpha
 * = |q_c| / k > 0 and |beta| = |p_c| / k, k = gcd(p_c, q_c), make column c vanish. Node by node,
 * weights of rows become weights of the rows they come from; at most one row more each time, so
 * that n + 3 places are enough.
 */
#include "elim/fmplex_path.h"

#include <assert.h>

static void factors(fmb_plexpath *g, const fmb_plexrow *r)
{
    const fmb_vec *p = &r->p->v, *q = &r->q->v;
    size_t c = (size_t)g->node[r->node - 1].var, k = 0;
    fmb_vec_get(p, c, g->beta);
    fmb_vec_get(q, c, g->alpha);
    mpz_gcd(g->t, g->alpha, g->beta);
    mpz_divexact(g->alpha, g->alpha, g->t);
    mpz_divexact(g->beta, g->beta, g->t);
    if (mpz_sgn(g->alpha) < 0)
        mpz_neg(g->alpha, g->alpha);
    else
        mpz_neg(g->beta, g->beta);
    while (fmb_vec_sgn(&r->v, k) == 0)
        k++; /* a false row is not 0 */
    fmb_vec_get(p, k, g->t);
    mpz_mul(mpq_numref(g->content), g->t, g->alpha);
    fmb_vec_get(q, k, g->u);
    mpz_addmul(mpq_numref(g->content), g->u, g->beta);
    fmb_vec_get(&r->v, k, mpq_denref(g->content));
    mpq_canonicalize(g->content);
}

/* A place with weight 0 for row r, unless it has one. */
static mpq_ptr place_of(fmb_plexpath *g, fmb_plexrow *r)
{
    if (r->slot == 0) {
        assert(g->actives < (size_t)g->n + 3);
        mpq_set_ui(g->weight[g->actives], 0, 1);
        g->active[g->actives++] = r;
        r->slot = (uint32_t)g->actives;
    }
    return g->weight[r->slot - 1];
}

/* Take row i out: the last one takes its place. */
static void remove_active(fmb_plexpath *g, size_t i)
{
    g->active[i]->slot = 0;
    if (i != --g->actives) {
        mpq_swap(g->weight[i], g->weight[g->actives]);
        g->active[i] = g->active[g->actives];
        g->active[i]->slot = (uint32_t)i + 1;
    }
}

static void share(fmb_plexpath *g, fmb_plexrow *parent, mpq_srcptr weight, mpz_srcptr factor)
{
    mpq_ptr sum = place_of(g, parent);
    mpq_set_z(g->share, factor);
    mpq_mul(g->share, g->share, weight);
    mpq_add(sum, sum, g->share);
}

/* Weights of rows made at node d become weights of the rows of node d - 1. */
static void push(fmb_plexpath *g, int d)
{
    mpq_t weight;
    mpq_init(weight);
    for (size_t i = 0; i < g->actives;) {
        fmb_plexrow *r = g->active[i];
        if (r->node != d) {
            i++;
            continue;
        }
        mpq_swap(weight, g->weight[i]);
        remove_active(g, i);
        factors(g, r);
        mpq_div(weight, weight, g->content);
        share(g, r->p, weight, g->alpha);
        share(g, r->q, weight, g->beta);
    }
    mpq_clear(weight);
}

static void forget(fmb_plexpath *g)
{
    while (g->actives > 0)
        g->active[--g->actives]->slot = 0;
}

/* Does the bound tried at this node follow from the other rows there? */
static bool is_implied(const fmb_plexpath *g, const fmb_plexnode *at)
{
    return at->via && !at->via->equality && at->via->slot != 0 &&
           mpq_sgn(g->weight[at->via->slot - 1]) < 0;
}

/* The bound to try after the one that is dropped: among those of the same side that imply it, the
 * one with the largest part in that. There is one: the conflict does not name var, so what the
 * dropped row adds to its column others of its sign must add, too. */
static fmb_plexrow *heir(fmb_plexpath *g, const fmb_plexnode *at)
{
    size_t var = (size_t)at->var;
    int side = fmb_vec_sgn(&at->via->v, var);
    fmb_plexrow *best = NULL;
    for (size_t i = 0; i < g->actives; i++) {
        fmb_plexrow *r = g->active[i];
        if (mpq_sgn(g->weight[i]) <= 0 || fmb_vec_sgn(&r->v, var) != side)
            continue;
        mpq_set_ui(g->share, 1, 1);
        fmb_vec_get(&r->v, var, mpq_numref(g->share));
        mpq_abs(g->share, g->share);
        mpq_mul(g->share, g->share, g->weight[i]);
        if (best && mpq_cmp(g->share, g->content) <= 0)
            continue;
        mpq_swap(g->share, g->content);
        best = r;
    }
    return best;
}

static void drop(fmb_plexpath *g, fmb_plexnode *at)
{
    size_t i = 0;
    fmb_plexrow *next = heir(g, at);
    assert(next);
    fmb_plexpath_cap(g, at, g->clash);
    while (at->live[i] != at->via)
        i++;
    at->live[i] = at->live[--at->lives];
    at->via = next;
}

static fmb_status report(const fmb_plexpath *g, fmb_weights *w)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; w && st == FMB_OK && i < g->actives; i++)
        if (mpq_sgn(g->weight[i]) != 0)
            st = fmb_weights_add(w, (uint32_t)(g->active[i] - g->node[0].made), g->weight[i],
                                 g->run->mem);
    return st;
}

fmb_status fmb_plexpath_retreat(fmb_plexpath *g, bool *global, fmb_weights *w)
{
    int d = g->depth;
    fmb_status st = FMB_OK;
    bool turn = g->clash->equality && fmb_vec_sgn(&g->clash->v, (size_t)g->n) > 0;
    mpq_set_si(place_of(g, g->clash), turn ? -1 : 1, 1);
    *global = true;
    for (; *global && st == FMB_OK && d > 0; d--) {
        push(g, d);
        *global = !is_implied(g, &g->node[d - 1]);
        st = fmb_run_poll(g->run);
    }
    if (!*global)
        drop(g, &g->node[d]);
    else if (st == FMB_OK)
        st = report(g, w);
    forget(g);
    fmb_plexpath_leave(g, d);
    return st;
}
