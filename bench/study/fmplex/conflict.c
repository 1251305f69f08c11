/* conflict.c: what a false row implies for the nodes above it; the proof is in fmplex.c.
 *
 * A row made from p and the bound q of the node above is (alpha p + beta q) / content, where alpha
 * = |q_c| and |beta| = |p_c| make column c vanish. Node by node, weights of rows become weights of
 * their parents; each node adds at most one row, so that n + 3 places are enough. Weights are
 * integers, as only their ratios count.
 */
#include "study/fmplex/path.h"

#include <assert.h>

static void factors(study_plexpath *g, const study_plexrow *r)
{
    const fmb_vec *p = &r->p->v, *q = &r->q->v;
    size_t c = (size_t)g->node[r->node - 1].var, k = 0;
    fmb_vec_get(p, c, g->beta);
    fmb_vec_get(q, c, g->alpha);
    if (mpz_sgn(g->alpha) < 0)
        mpz_neg(g->alpha, g->alpha);
    else
        mpz_neg(g->beta, g->beta);
    while (fmb_vec_sgn(&r->v, k) == 0)
        k++; /* a false row is not 0 */
    fmb_vec_get(p, k, g->t);
    mpz_mul(g->content, g->t, g->alpha);
    fmb_vec_get(q, k, g->t);
    mpz_addmul(g->content, g->t, g->beta);
    fmb_vec_get(&r->v, k, g->t);
    mpz_divexact(g->content, g->content, g->t);
}

/* A place with weight 0 for row r, unless it has one. */
static mpz_ptr place_of(study_plexpath *g, study_plexrow *r)
{
    if (r->slot == 0) {
        assert(g->actives < (size_t)g->n + 3);
        mpz_set_ui(g->weight[g->actives], 0);
        g->active[g->actives++] = r;
        r->slot = (uint32_t)g->actives;
    }
    return g->weight[r->slot - 1];
}

/* Remove row i: the last row takes its place. */
static void remove_active(study_plexpath *g, size_t i)
{
    g->active[i]->slot = 0;
    if (i != --g->actives) {
        mpz_swap(g->weight[i], g->weight[g->actives]);
        g->active[i] = g->active[g->actives];
        g->active[i]->slot = (uint32_t)i + 1;
    }
}

/* The weight `part` over content: as far as content does not divide it, all other weights are
 * multiplied instead. */
static void divide(study_plexpath *g)
{
    mpz_gcd(g->t, g->part, g->content);
    mpz_divexact(g->part, g->part, g->t);
    mpz_divexact(g->content, g->content, g->t);
    if (mpz_cmp_ui(g->content, 1) != 0)
        for (size_t i = 0; i < g->actives; i++)
            mpz_mul(g->weight[i], g->weight[i], g->content);
}

/* Divide all weights by their greatest common divisor. */
static void shorten(study_plexpath *g)
{
    mpz_set_ui(g->t, 0);
    for (size_t i = 0; i < g->actives && mpz_cmp_ui(g->t, 1) != 0; i++)
        mpz_gcd(g->t, g->t, g->weight[i]);
    for (size_t i = 0; i < g->actives && mpz_cmp_ui(g->t, 1) > 0; i++)
        mpz_divexact(g->weight[i], g->weight[i], g->t);
}

/* Weights of rows made at node d become weights of the rows of node d - 1. */
static void push(study_plexpath *g, int d)
{
    for (size_t i = 0; i < g->actives;) {
        study_plexrow *r = g->active[i];
        if (r->node != d) {
            i++;
            continue;
        }
        mpz_swap(g->part, g->weight[i]);
        remove_active(g, i);
        if (mpz_sgn(g->part) == 0)
            continue;
        factors(g, r);
        if (mpz_cmp_ui(g->content, 1) != 0)
            divide(g);
        mpz_addmul(place_of(g, r->p), g->alpha, g->part);
        mpz_addmul(place_of(g, r->q), g->beta, g->part);
    }
    shorten(g);
}

static void forget(study_plexpath *g)
{
    while (g->actives > 0)
        g->active[--g->actives]->slot = 0;
}

/* Does the bound tried at this node follow from the other rows there? */
static bool is_implied(const study_plexpath *g, const study_plexnode *at)
{
    return at->via && !at->via->equality && at->via->slot != 0 &&
           mpz_sgn(g->weight[at->via->slot - 1]) < 0;
}

/* The bound to try after the dropped one: of the bounds on the same side that imply it, the one
 * with the largest weight times coefficient. One exists: the others add up to a positive multiple
 * of the dropped row, so one of them has the same sign in column var. */
static study_plexrow *heir(study_plexpath *g, const study_plexnode *at)
{
    size_t var = (size_t)at->var;
    int side = fmb_vec_sgn(&at->via->v, var);
    study_plexrow *best = NULL;
    for (size_t i = 0; i < g->actives; i++) {
        study_plexrow *r = g->active[i];
        if (mpz_sgn(g->weight[i]) <= 0 || fmb_vec_sgn(&r->v, var) != side)
            continue;
        fmb_vec_get(&r->v, var, g->t);
        mpz_mul(g->part, g->t, g->weight[i]);
        if (best && mpz_cmpabs(g->part, g->content) <= 0)
            continue;
        mpz_swap(g->part, g->content);
        best = r;
    }
    return best;
}

static fmb_status report(const study_plexpath *g, fmb_weights *w)
{
    fmb_status st = FMB_OK;
    mpq_t value;
    mpq_init(value);
    for (size_t i = 0; w && st == FMB_OK && i < g->actives; i++) {
        mpq_set_z(value, g->weight[i]);
        if (mpq_sgn(value) != 0)
            st = fmb_weights_add(w, (uint32_t)(g->active[i] - g->node[0].made), value, g->run->mem);
    }
    mpq_clear(value);
    return st;
}

fmb_status study_plexpath_retreat(study_plexpath *g, bool *global, fmb_weights *w)
{
    int d = g->depth;
    fmb_status st = FMB_OK;
    bool turn = g->clash->equality && fmb_vec_sgn(&g->clash->v, (size_t)g->n) > 0;
    mpz_set_si(place_of(g, g->clash), turn ? -1 : 1);
    *global = true;
    for (; *global && st == FMB_OK && d > 0; d--) {
        push(g, d);
        *global = !is_implied(g, &g->node[d - 1]);
        st = fmb_run_poll(g->run);
    }
    if (!*global) {
        study_plexrow *next = heir(g, &g->node[d]);
        assert(next);
        study_plexpath_cap(g, &g->node[d], g->clash);
        study_plexpath_leave(g, d);
        study_plexpath_drop(g);
        g->node[d].via = next;
    } else if (st == FMB_OK) {
        st = report(g, w);
    }
    forget(g);
    return st;
}
