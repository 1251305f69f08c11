/* naive_steps.c: claims WHOLE that give an order of elimination, on tables of rationals; see
 * naive.h. All pairs are combined unless the union of their histories contains another row's. */
#include <stdlib.h>

#include "naive.h"
#include "support/dense.h"

enum { MOST = 4096 }; /* rows */

typedef struct left_row {
    mpq_t *a; /* [dim + 1] */
    fmb_rel rel;
    uint64_t of;
} left_row;

typedef struct left_rows {
    int dim, rows;
    left_row row[MOST];
} left_rows;

static left_row *append(left_rows *l)
{
    if (l->rows == MOST)
        abort();
    left_row *r = &l->row[l->rows++];
    r->a = malloc((size_t)(l->dim + 1) * sizeof *r->a);
    if (!r->a)
        abort();
    for (int j = 0; j <= l->dim; j++)
        mpq_init(r->a[j]);
    return r;
}

static void drop(left_rows *l, int i)
{
    for (int j = 0; j <= l->dim; j++)
        mpq_clear(l->row[i].a[j]);
    free(l->row[i].a);
    l->rows--;
    for (int k = i; k < l->rows; k++)
        l->row[k] = l->row[k + 1];
}

/* to = a p + b q. */
static void combine(const left_rows *l, mpq_t *to, mpq_t *p, const mpq_t a, mpq_t *q, const mpq_t b)
{
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    for (int j = 0; j <= l->dim; j++) {
        mpq_mul(x, p[j], a);
        mpq_mul(y, q[j], b);
        mpq_add(to[j], x, y);
    }
    mpq_clears(x, y, NULL);
}

static void substitute(left_rows *l, int equality, int v)
{
    mpq_t one, factor;
    mpq_inits(one, factor, NULL);
    mpq_set_ui(one, 1, 1);
    for (int i = 0; i < l->rows; i++) {
        if (i == equality)
            continue;
        mpq_div(factor, l->row[i].a[v], l->row[equality].a[v]);
        mpq_neg(factor, factor);
        combine(l, l->row[i].a, l->row[i].a, one, l->row[equality].a, factor);
    }
    mpq_clears(one, factor, NULL);
    drop(l, equality);
}

/* Of so many inequalities, the pair p, q comes in if none of the rows without v says it is in vain.
 */
static void try_pair(left_rows *l, int p, int q, int v, int size)
{
    uint64_t of = l->row[p].of | l->row[q].of;
    bool covers = __builtin_popcountll(of) != size;
    for (int i = 0; !covers && i < l->rows; i++)
        covers =
            l->row[i].rel != FMB_EQ && mpq_sgn(l->row[i].a[v]) == 0 && (l->row[i].of & ~of) == 0;
    if (covers)
        return;
    mpq_t minus;
    mpq_init(minus);
    mpq_neg(minus, l->row[q].a[v]);
    left_row *to = append(l);
    combine(l, to->a, l->row[p].a, minus, l->row[q].a, l->row[p].a[v]);
    to->of = of;
    to->rel = l->row[p].rel == FMB_LT || l->row[q].rel == FMB_LT ? FMB_LT : FMB_LE;
    mpq_clear(minus);
}

static void eliminate(left_rows *l, int v)
{
    for (int i = 0; i < l->rows; i++)
        if (l->row[i].rel == FMB_EQ && mpq_sgn(l->row[i].a[v]) != 0) {
            substitute(l, i, v);
            return;
        }
    int rows = l->rows;
    for (int size = 1; size <= 64; size++)
        for (int p = 0; p < rows; p++)
            for (int q = 0; mpq_sgn(l->row[p].a[v]) > 0 && q < rows; q++)
                if (mpq_sgn(l->row[q].a[v]) < 0)
                    try_pair(l, p, q, v, size);
    for (int i = rows - 1; i >= 0; i--)
        if (mpq_sgn(l->row[i].a[v]) != 0)
            drop(l, i);
}

static left_rows *eliminate_all(const dense *d, const fmb_sparse_vector *steps)
{
    left_rows *l = malloc(sizeof *l);
    bool *gone = calloc(steps->size + 1, sizeof *gone);
    if (!l || !gone || d->rows > 64)
        abort();
    l->dim = d->dim;
    l->rows = 0;
    for (int i = 0; i < d->rows; i++) {
        left_row *r = append(l);
        r->rel = d->rel[i];
        r->of = d->rel[i] == FMB_EQ ? 0 : (uint64_t)1 << i;
        for (int j = 0; j <= d->dim; j++)
            mpq_set(r->a[j], dense_row(d, i)[j]);
    }
    for (size_t n = 0; n < steps->size; n++) {
        size_t next = SIZE_MAX;
        for (size_t k = 0; k < steps->size; k++)
            if (!gone[k] && (next == SIZE_MAX || mpq_cmp(steps->value[k], steps->value[next]) < 0))
                next = k;
        gone[next] = true;
        eliminate(l, (int)steps->index[next]);
    }
    free(gone);
    return l;
}

static bool names_kept(const fmb_claim *c, const bool *kept, int dim)
{
    bool good = true;
    for (size_t k = 0; k < c->terms.size; k++)
        good = good && c->terms.index[k] < (size_t)dim && kept[c->terms.index[k]];
    return good;
}

static bool is_said(const fmb_evidence *e, const fmb_claim *c, const bool *kept)
{
    bool good = names_kept(c, kept, e->dim);
    if (c->kind == FMB_CLAIM_FOLLOWS)
        for (size_t k = 0; good && k < c->multipliers.size; k++)
            good = names_kept(&e->claim[c->multipliers.index[k]], kept, e->dim);
    return good && (c->kind == FMB_CLAIM_IMPLIED || c->kind == FMB_CLAIM_FOLLOWS);
}

/* Is the row times sign a multiple of the claim times back, and no tighter? */
static bool says(const left_rows *l, const left_row *r, int sign, const fmb_claim *c, int back)
{
    mpq_t factor, t;
    bool good = true;
    mpq_inits(factor, t, NULL);
    for (int j = 0; j < l->dim; j++) {
        mpq_srcptr g = fmb_sparse_find(&c->terms, (size_t)j);
        bool zero = !g || mpq_sgn(g) == 0;
        good = good && zero == (mpq_sgn(r->a[j]) == 0);
        if (!good || zero)
            continue;
        mpq_div(t, r->a[j], g);
        if (mpq_sgn(factor) == 0)
            mpq_set(factor, t);
        good = mpq_equal(t, factor);
    }
    mpq_mul(t, c->value, factor);
    int order = sign * mpq_cmp(t, r->a[l->dim]);
    good = good && sign * back * mpq_sgn(factor) > 0 &&
           (order < 0 || (order == 0 && (c->rel == FMB_LT || r->rel != FMB_LT)));
    mpq_clears(factor, t, NULL);
    return good;
}

static bool is_row_said(const left_rows *l, const left_row *r, int sign, const fmb_evidence *e,
                        const bool *kept)
{
    bool constant = true, found = false;
    for (int j = 0; j < l->dim; j++) {
        if (!kept[j] && mpq_sgn(r->a[j]) != 0)
            return false;
        constant = constant && mpq_sgn(r->a[j]) == 0;
    }
    int side = sign * mpq_sgn(r->a[l->dim]);
    if (constant)
        return r->rel == FMB_LT ? side > 0 : side >= 0;
    for (size_t i = 0; !found && i < e->claims; i++) {
        const fmb_claim *c = &e->claim[i];
        found = is_said(e, c, kept) &&
                (says(l, r, sign, c, 1) || (c->rel == FMB_EQ && says(l, r, sign, c, -1)));
    }
    return found;
}

bool naive_is_whole_by_steps(const dense *d, const fmb_evidence *e, const fmb_claim *q)
{
    bool good = q->var == -1, *kept = calloc((size_t)d->dim + 1, sizeof *kept);
    if (!kept)
        abort();
    for (size_t k = 0; good && k < q->terms.size; k++) {
        good = q->terms.index[k] < (size_t)d->dim;
        if (good)
            kept[q->terms.index[k]] = true;
    }
    for (size_t k = 0; good && k < q->point.size; k++)
        good = q->point.index[k] < (size_t)d->dim && !kept[q->point.index[k]];
    left_rows *l = good ? eliminate_all(d, &q->point) : NULL;
    for (int i = 0; good && i < l->rows; i++)
        good = is_row_said(l, &l->row[i], 1, e, kept) &&
               (l->row[i].rel != FMB_EQ || is_row_said(l, &l->row[i], -1, e, kept));
    while (l && l->rows > 0)
        drop(l, l->rows - 1);
    free(l);
    free(kept);
    return good;
}
