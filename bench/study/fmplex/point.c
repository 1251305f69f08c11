/* point.c: a solution, from a node whose rows name no variable.
 *
 * The infinitesimal d becomes the largest 2^-k within all caps of the path, so that everything
 * found true for small d is true for it. Then, from the last node up, the values of the variables
 * below satisfy every row made with the node's via and var, so that var fits between its bounds
 * there; dropped rows follow from the others.
 */
#include "elim/round/witness.h"
#include "study/fmplex/path.h"

typedef struct span {
    mpq_t delta, lower, upper, value, t;
    bool has_lower, has_upper;
} span;

static void choose_delta(const study_plexpath *g, mpq_t delta)
{
    mpq_set_ui(delta, 1, 1);
    for (int d = 0; d <= g->depth; d++)
        while (g->node[d].capped && mpq_cmp(delta, g->node[d].cap) > 0)
            mpq_div_2exp(delta, delta, 1);
}

static void subtract(span *s, const fmb_vec *v, size_t j, mpq_srcptr x)
{
    if (fmb_vec_sgn(v, j) == 0)
        return;
    mpq_set_ui(s->t, 1, 1);
    fmb_vec_get(v, j, mpq_numref(s->t));
    mpq_mul(s->t, s->t, x);
    mpq_sub(s->value, s->value, s->t);
}

/* value = (b - s delta - the other terms) / a_var: the bound that row r puts on var. */
static void bound_of(const study_plexpath *g, const study_plexrow *r, size_t var, mpq_t *x, span *s)
{
    size_t n = (size_t)g->n;
    mpq_set_ui(s->value, 0, 1);
    fmb_vec_get(&r->v, n, mpq_numref(s->value));
    for (size_t j = 0; j < n; j++)
        if (j != var)
            subtract(s, &r->v, j, x[j]);
    if (n + 1 < g->length)
        subtract(s, &r->v, n + 1, s->delta);
    mpq_set_ui(s->t, 1, 1);
    fmb_vec_get(&r->v, var, mpq_numref(s->t));
    mpq_div(s->value, s->value, s->t);
}

static void narrow(span *s, bool is_lower)
{
    mpq_ptr end = is_lower ? s->lower : s->upper;
    bool *has = is_lower ? &s->has_lower : &s->has_upper;
    int order = *has ? mpq_cmp(s->value, end) : 0;
    if (!*has || (is_lower ? order > 0 : order < 0))
        mpq_set(end, s->value);
    *has = true;
}

static fmb_status solve(const study_plexpath *g, const study_plexnode *at, mpq_t *x, span *s)
{
    fmb_status st = FMB_OK;
    size_t var = (size_t)at->var;
    s->has_lower = s->has_upper = false;
    for (size_t i = 0; st == FMB_OK && i < at->lives; i++) {
        const study_plexrow *r = at->live[i];
        int sign = fmb_vec_sgn(&r->v, var);
        if (sign == 0)
            continue;
        bound_of(g, r, var, x, s);
        if (r == at->via && r->equality) {
            mpq_set(x[var], s->value);
            return FMB_OK;
        }
        narrow(s, sign < 0);
        st = fmb_run_poll(g->run);
    }
    fmb_simple_between(x[var], s->has_lower ? s->lower : NULL, false,
                       s->has_upper ? s->upper : NULL, false);
    return st;
}

fmb_status study_plexpath_point(const study_plexpath *g, mpq_t *x)
{
    span s;
    fmb_status st = FMB_OK;
    mpq_inits(s.delta, s.lower, s.upper, s.value, s.t, NULL);
    choose_delta(g, s.delta);
    for (int j = 0; j < g->n; j++)
        mpq_set_ui(x[j], 0, 1);
    for (int d = g->depth; st == FMB_OK && d-- > 0;)
        st = solve(g, &g->node[d], x, &s);
    mpq_clears(s.delta, s.lower, s.upper, s.value, s.t, NULL);
    return st;
}
