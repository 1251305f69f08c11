/* claimed_rows.c: see claimed_rows.h. */
#include "solve/project/claimed_rows.h"

#include <stdlib.h>
#include <string.h>

#include "num/rationals.h"

fmb_status fmb_claimed_rows_open(fmb_claimed_rows *c, fmb_query *q, const int *place,
                                 fmb_system *image)
{
    fmb_mem *mem = q->run.mem;
    *c = (fmb_claimed_rows){.q = q, .image = image};
    FMB_TRY(FMB_GET(mem, c->variable, (size_t)fmb_system_dim(image)));
    for (int j = 0; j < fmb_system_dim(q->s); j++)
        if (place[j] >= 0)
            c->variable[place[j]] = j;
    if (!q->claims)
        return FMB_OK;
    c->first = q->claims->claims - image->rows;
    c->touched = fmb_mem_get(mem, q->s->rows, sizeof *c->touched);
    c->is_touched = fmb_mem_zero(mem, q->s->rows, sizeof *c->is_touched);
    return c->touched && c->is_touched ? fmb_rationals_new(&c->sum, q->s->rows, mem)
                                       : fmb_mem_status(mem);
}

void fmb_claimed_rows_close(fmb_claimed_rows *c)
{
    fmb_mem *mem = c->q->run.mem;
    fmb_rationals_free(c->sum, c->q->s->rows, mem);
    fmb_mem_put(mem, c->touched, c->q->s->rows, sizeof *c->touched);
    fmb_mem_put(mem, c->is_touched, c->q->s->rows, sizeof *c->is_touched);
    fmb_mem_put(mem, c->variable, (size_t)fmb_system_dim(c->image), sizeof *c->variable);
}

/* ---- claims ---------------------------------------------------------------------------------- */

static int compare_indices(const void *a, const void *b)
{
    size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

/* c->sum += factor * list; rows not yet in touched are appended to it. */
static void add_multiple(fmb_claimed_rows *c, const fmb_sparse_vector *list, mpq_srcptr factor,
                         size_t *touched)
{
    mpq_t t;
    mpq_init(t);
    for (size_t k = 0; k < list->size; k++) {
        size_t i = list->index[k];
        if (!c->is_touched[i])
            c->touched[(*touched)++] = i;
        c->is_touched[i] = true;
        mpq_mul(t, list->value[k], factor);
        mpq_add(c->sum[i], c->sum[i], t);
    }
    mpq_clear(t);
}

/* to = sign times the combination w, as multipliers of the rows of the query's system. */
static fmb_status push_sum(fmb_claimed_rows *c, const fmb_weights *w, int sign,
                           fmb_sparse_vector *to, fmb_evidence *e)
{
    fmb_status st = FMB_OK;
    size_t touched = 0;
    mpq_t factor;
    mpq_init(factor);
    for (size_t k = 0; st == FMB_OK && k < w->size; k++) {
        const fmb_claim *of = &e->claim[c->first + w->index[k]];
        bool reverse = mpq_sgn(w->value[k]) * sign < 0;
        mpq_abs(factor, w->value[k]);
        add_multiple(c, reverse ? &of->reverse : &of->multipliers, factor, &touched);
        st = fmb_run_poll(&c->q->run);
    }
    mpq_clear(factor);
    qsort(c->touched, touched, sizeof *c->touched, compare_indices);
    for (size_t k = 0; k < touched; k++) {
        size_t i = c->touched[k];
        FMB_THEN(st, fmb_evidence_push(e, to, i, c->sum[i]));
        mpq_set_ui(c->sum[i], 0, 1);
        c->is_touched[i] = false;
    }
    return st;
}

static fmb_status fill_claim_of_row(fmb_claimed_rows *c, fmb_claim *claim, mpz_t *z, fmb_rel rel,
                                    const fmb_weights *w)
{
    fmb_evidence *e = c->q->claims;
    size_t n = (size_t)fmb_system_dim(c->image);
    fmb_status st = FMB_OK;
    mpq_t t;
    mpq_init(t);
    claim->rel = rel;
    mpq_set_z(claim->value, z[n]);
    for (size_t j = 0; st == FMB_OK && j < n; j++) {
        mpq_set_z(t, z[j]);
        st = fmb_evidence_push(e, &claim->terms, (size_t)c->variable[j], t);
    }
    mpq_clear(t);
    FMB_THEN(st, push_sum(c, w, 1, &claim->multipliers, e));
    return st == FMB_OK && rel == FMB_EQ ? push_sum(c, w, -1, &claim->reverse, e) : st;
}

static fmb_status append_claim(fmb_claimed_rows *c, mpz_t *z, fmb_rel rel, const fmb_weights *w)
{
    fmb_claim *claim;
    if (!c->q->claims)
        return FMB_OK;
    FMB_TRY(fmb_evidence_claim(c->q->claims, FMB_CLAIM_IMPLIED, &claim));
    fmb_status st = fill_claim_of_row(c, claim, z, rel, w);
    if (st != FMB_OK)
        fmb_evidence_drop_last(c->q->claims);
    return st;
}

/* ---- rows ------------------------------------------------------------------------------------ */

fmb_status fmb_claimed_rows_append(fmb_claimed_rows *c, mpz_t *z, fmb_rel rel, const fmb_weights *w)
{
    const fmb_vec row = {.z = z};
    FMB_TRY(
        fmb_system_append_dense(c->image, (size_t)fmb_system_dim(c->image), NULL, NULL, &row, rel));
    fmb_status st = append_claim(c, z, rel, w);
    if (st != FMB_OK)
        fmb_system_remove(c->image, c->image->rows - 1);
    return st;
}

void fmb_claimed_rows_put_last(fmb_claimed_rows *c, size_t i)
{
    size_t last = c->image->rows - 1;
    fmb_sysrow row = c->image->row[i];
    c->image->row[i] = c->image->row[last];
    c->image->row[last] = row;
    fmb_system_remove(c->image, last);
    if (!c->q->claims)
        return;
    fmb_claim *list = c->q->claims->claim + c->first, claim = list[i];
    list[i] = list[last];
    list[last] = claim;
    fmb_evidence_drop_last(c->q->claims);
}

void fmb_claimed_rows_drop(fmb_claimed_rows *c, size_t i)
{
    fmb_system_remove(c->image, i);
    if (!c->q->claims)
        return;
    size_t behind = c->image->rows - i;
    fmb_claim *at = c->q->claims->claim + c->first + i, claim = *at;
    memmove(at, at + 1, behind * sizeof *at);
    at[behind] = claim;
    fmb_evidence_drop_last(c->q->claims);
}

/* ---- their order ----------------------------------------------------------------------------- */

typedef struct placed_row {
    fmb_sysrow row; /* first: pointers to both are alike */
    size_t was;     /* its number */
} placed_row;

static int compare_placed_rows(const void *a, const void *b)
{
    return fmb_sysrow_compare(a, b);
}

static fmb_status sort_claims(fmb_claimed_rows *c, const placed_row *sorted)
{
    fmb_mem *mem = c->q->run.mem;
    size_t rows = c->image->rows;
    if (!c->q->claims)
        return FMB_OK;
    fmb_claim *from, *to = c->q->claims->claim + c->first;
    FMB_TRY(FMB_GET(mem, from, rows));
    memcpy(from, to, rows * sizeof *from);
    for (size_t i = 0; i < rows; i++)
        to[i] = from[sorted[i].was];
    fmb_mem_put(mem, from, rows, sizeof *from);
    return FMB_OK;
}

fmb_status fmb_claimed_rows_sort(fmb_claimed_rows *c)
{
    fmb_mem *mem = c->q->run.mem;
    size_t rows = c->image->rows;
    if (rows < 2)
        return FMB_OK;
    placed_row *sorted;
    FMB_TRY(FMB_GET(mem, sorted, rows));
    for (size_t i = 0; i < rows; i++)
        sorted[i] = (placed_row){c->image->row[i], i};
    qsort(sorted, rows, sizeof *sorted, compare_placed_rows);
    fmb_status st = sort_claims(c, sorted);
    for (size_t i = 0; st == FMB_OK && i < rows; i++)
        c->image->row[i] = sorted[i].row;
    fmb_mem_put(mem, sorted, rows, sizeof *sorted);
    return st;
}
