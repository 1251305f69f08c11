/* naive.c: every definition of docs/proof-format.md spelled out on dense tables of reduced
 * rationals; see naive.h. Slow, and shares nothing with lib/proof/check.c. */
#include "naive.h"

#include <stdlib.h>

#include "support/dense.h"

/* a.x REL b; b stands behind the coefficients. */
typedef struct inequality {
    mpq_t *a;
    fmb_rel rel;
} inequality;

static mpq_t *zeros(int n)
{
    mpq_t *q = malloc((size_t)(n + 1) * sizeof *q);
    if (!q)
        abort();
    for (int j = 0; j <= n; j++)
        mpq_init(q[j]);
    return q;
}

static void put(mpq_t *q, int n)
{
    for (int j = 0; j <= n; j++)
        mpq_clear(q[j]);
    free(q);
}

/* sum over j of a_j x_j, minus b unless it is a direction: its sign. */
static int excess(int dim, mpq_t *a, const fmb_sparse_vector *x, bool direction)
{
    mpq_t sum, term;
    mpq_inits(sum, term, NULL);
    for (size_t k = 0; k < x->size; k++) {
        mpq_mul(term, a[x->index[k]], x->value[k]);
        mpq_add(sum, sum, term);
    }
    if (!direction)
        mpq_sub(sum, sum, a[dim]);
    int sign = mpq_sgn(sum);
    mpq_clears(sum, term, NULL);
    return sign;
}

/* Is every coordinate one of the space? */
static bool is_point(int dim, const fmb_sparse_vector *x)
{
    bool good = true;
    for (size_t k = 0; k < x->size; k++)
        good = good && x->index[k] < (size_t)dim;
    return good;
}

static bool holds(int sign, fmb_rel rel)
{
    switch (rel) {
    case FMB_LE:
        return sign <= 0;
    case FMB_LT:
        return sign < 0;
    default:
        return sign == 0;
    }
}

static bool is_solution(const dense *d, const fmb_sparse_vector *x)
{
    for (int i = 0; is_point(d->dim, x) && i < d->rows; i++)
        if (!holds(excess(d->dim, dense_row(d, i), x, false), d->rel[i]))
            return false;
    return is_point(d->dim, x);
}

/* A solution of the closed system. */
static bool is_closed_solution(const dense *d, const fmb_sparse_vector *x)
{
    for (int i = 0; is_point(d->dim, x) && i < d->rows; i++) {
        fmb_rel rel = d->rel[i] == FMB_EQ ? FMB_EQ : FMB_LE;
        if (!holds(excess(d->dim, dense_row(d, i), x, false), rel))
            return false;
    }
    return is_point(d->dim, x);
}

static bool is_direction(const dense *d, const fmb_sparse_vector *x)
{
    for (int i = 0; is_point(d->dim, x) && i < d->rows; i++) {
        fmb_rel rel = d->rel[i] == FMB_EQ ? FMB_EQ : FMB_LE;
        if (!holds(excess(d->dim, dense_row(d, i), x, true), rel))
            return false;
    }
    return is_point(d->dim, x);
}

/* Do the multipliers of rows of d turn them into a row at least as strong as goal (not =)? */
static bool derives(const dense *d, const fmb_sparse_vector *m, inequality goal)
{
    bool good = true, strict = false;
    mpq_t *sum = zeros(d->dim), term;
    mpq_init(term);
    for (size_t k = 0; k < m->size; k++) {
        if (m->index[k] >= (size_t)d->rows) {
            good = false;
            continue;
        }
        int i = (int)m->index[k];
        good = good && (d->rel[i] == FMB_EQ || mpq_sgn(m->value[k]) >= 0);
        strict = strict || (d->rel[i] == FMB_LT && mpq_sgn(m->value[k]) != 0);
        for (int j = 0; j <= d->dim; j++) {
            mpq_mul(term, m->value[k], dense_row(d, i)[j]);
            mpq_add(sum[j], sum[j], term);
        }
    }
    for (int j = 0; j < d->dim; j++)
        good = good && mpq_equal(sum[j], goal.a[j]);
    int order = mpq_cmp(sum[d->dim], goal.a[d->dim]);
    good = good && (order < 0 || (order == 0 && (strict || goal.rel == FMB_LE)));
    mpq_clear(term);
    put(sum, d->dim);
    return good;
}

/* The same for a goal that may be an equality: the reverse needs multipliers of its own. */
static bool derives_both(const dense *d, const fmb_sparse_vector *m,
                         const fmb_sparse_vector *reverse, inequality goal)
{
    if (goal.rel != FMB_EQ)
        return derives(d, m, goal);
    inequality there = {goal.a, FMB_LE}, back = {zeros(d->dim), FMB_LE};
    for (int j = 0; j <= d->dim; j++)
        mpq_neg(back.a[j], goal.a[j]);
    bool good = derives(d, m, there) && derives(d, reverse, back);
    put(back.a, d->dim);
    return good;
}

/* ---- claims ---------------------------------------------------------------------------------- */

typedef struct scene {
    const fmb_evidence *e;
    dense rows;    /* as written */
    dense final;   /* all rows, as equalities where a claim says so */
    dense present; /* the same, but rows that go some time are as written */
    bool feasible;
    bool doubtful; /* a claim other than WHOLE does not hold */
} scene;

static bool holds_infeasible(const scene *v, const fmb_claim *c)
{
    inequality goal = {zeros(v->rows.dim), FMB_LT};
    bool good = derives(&v->rows, &c->multipliers, goal);
    put(goal.a, v->rows.dim);
    return good;
}

/* a[0..dim) = sign times the form of the claim: its variable and its terms; a[dim] = sign times its
 * value. False: it names variables that there are not. */
static bool form_of_claim(int dim, const fmb_claim *c, int sign, mpq_t *a)
{
    bool good = c->var >= -1 && c->var < dim;
    mpq_t one;
    mpq_init(one);
    mpq_set_si(one, 1, 1);
    if (good && c->var >= 0)
        mpq_add(a[c->var], a[c->var], one);
    for (size_t k = 0; k < c->terms.size; k++) {
        size_t j = c->terms.index[k];
        good = good && j < (size_t)dim;
        if (j < (size_t)dim)
            mpq_add(a[j], a[j], c->terms.value[k]);
    }
    mpq_set(a[dim], c->value);
    mpq_set_si(one, sign, 1);
    for (int j = 0; j <= dim; j++)
        mpq_mul(a[j], a[j], one);
    mpq_clear(one);
    return good;
}

static bool holds_bound(const scene *v, const fmb_claim *c)
{
    int dim = v->rows.dim;
    inequality goal = {zeros(dim), c->rel};
    bool good = form_of_claim(dim, c, c->side == FMB_UPPER ? 1 : -1, goal.a) &&
                (c->rel == FMB_LE || c->rel == FMB_LT) && derives(&v->rows, &c->multipliers, goal);
    bool tight = c->rel == FMB_LE ? is_solution(&v->rows, &c->point)
                                  : v->feasible && is_closed_solution(&v->rows, &c->point);
    good = good && tight && excess(dim, goal.a, &c->point, false) == 0;
    put(goal.a, dim);
    return good;
}

static bool holds_unbounded(const scene *v, const fmb_claim *c)
{
    int dim = v->rows.dim;
    mpq_t *form = zeros(dim);
    bool good = form_of_claim(dim, c, c->side == FMB_UPPER ? 1 : -1, form) && v->feasible &&
                is_direction(&v->rows, &c->ray) && excess(dim, form, &c->ray, true) > 0;
    put(form, dim);
    return good;
}

static bool holds_implied(const scene *v, const fmb_claim *c)
{
    int dim = v->rows.dim;
    inequality goal = {zeros(dim), c->rel};
    bool good = c->var == -1 && form_of_claim(dim, c, 1, goal.a);
    good = good && derives_both(&v->rows, &c->multipliers, &c->reverse, goal);
    put(goal.a, dim);
    return good;
}

/* Is the row named by a claim REDUNDANT among the first n? */
static bool goes_in(const scene *v, size_t row, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (v->e->claim[i].kind == FMB_CLAIM_REDUNDANT && v->e->claim[i].row == row)
            return true;
    return false;
}

/* No multiplier of a row that goes before this claim or by it. */
static bool uses_only_present(const scene *v, const fmb_sparse_vector *m, const fmb_claim *c)
{
    for (size_t k = 0; k < m->size; k++)
        if (goes_in(v, m->index[k], (size_t)(c - v->e->claim) + 1))
            return false;
    return true;
}

static bool holds_redundant(const scene *v, const fmb_claim *c)
{
    if (c->row >= (size_t)v->rows.rows)
        return false;
    int i = (int)c->row;
    inequality goal = {dense_row(&v->rows, i), v->rows.rel[i]};
    return uses_only_present(v, &c->multipliers, c) &&
           (goal.rel != FMB_EQ || uses_only_present(v, &c->reverse, c)) &&
           derives_both(&v->present, &c->multipliers, &c->reverse, goal);
}

static bool holds_equality(const scene *v, const fmb_claim *c)
{
    int dim = v->rows.dim;
    if (c->row >= (size_t)v->rows.rows || v->rows.rel[c->row] == FMB_LT)
        return false;
    inequality back = {zeros(dim), FMB_LE};
    for (int j = 0; j <= dim; j++)
        mpq_neg(back.a[j], dense_row(&v->rows, (int)c->row)[j]);
    dense known = dense_without(&v->rows, -1, -1);
    for (const fmb_claim *before = v->e->claim; before < c; before++)
        if (before->kind == FMB_CLAIM_EQUALITY && before->row < (size_t)known.rows)
            known.rel[before->row] = FMB_EQ;
    bool good = derives(&known, &c->multipliers, back);
    dense_free(&known);
    put(back.a, dim);
    return good;
}

static bool holds_irredundant(const scene *v, const fmb_claim *c)
{
    if (c->row >= (size_t)v->rows.rows || !is_point(v->rows.dim, &c->point))
        return false;
    int row = (int)c->row;
    for (int i = 0; i < v->rows.rows; i++)
        if (i != row && !goes_in(v, (size_t)i, v->e->claims) &&
            !holds(excess(v->rows.dim, dense_row(&v->final, i), &c->point, false), v->final.rel[i]))
            return false;
    return !holds(excess(v->rows.dim, dense_row(&v->final, row), &c->point, false),
                  v->final.rel[row]);
}

/* Claims IMPLIED as rows of a table, which multipliers may name; all others are not to be. */
static bool holds_follows(const scene *v, const fmb_claim *c)
{
    int dim = v->rows.dim;
    dense said = dense_new(dim, (int)v->e->claims);
    inequality goal = {zeros(dim), c->rel};
    bool good = c->rel != FMB_EQ && c->var == -1 && is_point(dim, &c->terms);
    for (size_t k = 0; good && k < c->multipliers.size; k++) {
        size_t on = c->multipliers.index[k];
        good = on < v->e->claims && v->e->claim[on].kind == FMB_CLAIM_IMPLIED &&
               is_point(dim, &v->e->claim[on].terms);
        for (size_t i = 0; good && i < v->e->claim[on].terms.size; i++)
            mpq_set(dense_row(&said, (int)on)[v->e->claim[on].terms.index[i]],
                    v->e->claim[on].terms.value[i]);
        if (good) {
            mpq_set(dense_rhs(&said, (int)on), v->e->claim[on].value);
            said.rel[on] = v->e->claim[on].rel;
        }
    }
    for (size_t i = 0; good && i < c->terms.size; i++)
        mpq_set(goal.a[c->terms.index[i]], c->terms.value[i]);
    mpq_set(goal.a[dim], c->value);
    good = good && derives(&said, &c->multipliers, goal);
    put(goal.a, dim);
    dense_free(&said);
    return good;
}

static bool claim_holds(const scene *v, const fmb_claim *c)
{
    switch (c->kind) {
    case FMB_CLAIM_FEASIBLE:
        return is_solution(&v->rows, &c->point);
    case FMB_CLAIM_INFEASIBLE:
        return holds_infeasible(v, c);
    case FMB_CLAIM_BOUND:
        return holds_bound(v, c);
    case FMB_CLAIM_UNBOUNDED:
        return holds_unbounded(v, c);
    case FMB_CLAIM_IMPLIED:
        return holds_implied(v, c);
    case FMB_CLAIM_REDUNDANT:
        return holds_redundant(v, c);
    case FMB_CLAIM_EQUALITY:
        return holds_equality(v, c);
    case FMB_CLAIM_IRREDUNDANT:
        return holds_irredundant(v, c);
    case FMB_CLAIM_CORNER:
        return c->ray.size == 0 ? is_closed_solution(&v->rows, &c->point)
                                : c->point.size == 0 && is_direction(&v->rows, &c->ray);
    case FMB_CLAIM_WHOLE:
        return !v->doubtful && (c->point.size > 0 ? naive_is_whole_by_steps(&v->rows, v->e, c)
                                                  : naive_is_whole(&v->rows, v->e, c));
    case FMB_CLAIM_FOLLOWS:
        return holds_follows(v, c);
    default:
        return false;
    }
}

/* Fill in what all claims together say. */
static void look_around(scene *v)
{
    for (size_t i = 0; i < v->e->claims; i++) {
        const fmb_claim *c = &v->e->claim[i];
        if (c->kind == FMB_CLAIM_FEASIBLE && is_solution(&v->rows, &c->point))
            v->feasible = true;
        if (c->kind != FMB_CLAIM_EQUALITY || c->row >= (size_t)v->rows.rows)
            continue;
        v->final.rel[c->row] = FMB_EQ;
        if (!goes_in(v, c->row, v->e->claims))
            v->present.rel[c->row] = FMB_EQ;
    }
    for (size_t i = 0; i < v->e->claims; i++)
        v->doubtful = v->doubtful ||
                      (v->e->claim[i].kind != FMB_CLAIM_WHOLE && !claim_holds(v, &v->e->claim[i]));
}

size_t naive_first_failing(const fmb_system *s, const fmb_evidence *e)
{
    scene v = {e, dense_of(s), dense_of(s), dense_of(s), false, false};
    size_t failing = SIZE_MAX;
    look_around(&v);
    for (size_t i = 0; i < e->claims && failing == SIZE_MAX; i++)
        if (!claim_holds(&v, &e->claim[i]))
            failing = i;
    dense_free(&v.rows);
    dense_free(&v.present);
    dense_free(&v.final);
    return failing;
}
