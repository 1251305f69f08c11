/* thin.c: of the rows that an elimination left, those that are irredundant; see thin.h.
 *
 * Most rows are settled by guesses that are proved at once (lp/implied.h); the oracle decides about
 * the others, and finds the inequalities that always hold with equality.
 */
#include "solve/thin.h"

#include "elim/derive.h"
#include "lp/implied.h"
#include "solve/irredundant.h"
#include "system/system.h"

/* The rows left. Row k of the oracle is row e->live[k] of the store. */
typedef struct remains {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for variables that go */
    fmb_elim *e;
    fmb_system *out;
    fmb_lp lp;
    bool has_lp;
    fmb_lp_row *row;      /* [lives] */
    fmb_rel *rel;         /* [lives] */
    fmb_fate *fate;       /* [lives] */
    fmb_weights *reverse; /* [lives] proofs that rows are equalities, over oracle rows */
} remains;

/* ---- evidence -------------------------------------------------------------------------------- */

/* Weights over oracle rows become weights over the part's rows. */
static fmb_status derive(const remains *h, fmb_weights *w)
{
    for (size_t i = 0; i < w->size; i++)
        w->index[i] = h->e->live.row[w->index[i]];
    return fmb_elim_derive(h->e, w);
}

static fmb_status add_scaled(remains *h, fmb_weights *sum, const fmb_weights *w, mpq_srcptr factor)
{
    fmb_status st = FMB_OK;
    mpq_t t;
    mpq_init(t);
    for (size_t k = 0; st == FMB_OK && k < w->size; k++) {
        mpq_mul(t, w->value[k], factor);
        st = fmb_weights_add(sum, w->index[k], t, h->q->run.mem);
    }
    mpq_clear(t);
    return st;
}

/* The oracle may have used a row that it knows to be an equality backwards: what proved that stands
 * in for it. */
static fmb_status note_equality(void *self, size_t i, const fmb_weights *w)
{
    remains *h = self;
    fmb_status st = FMB_OK;
    mpq_t size;
    mpq_init(size);
    for (size_t k = 0; st == FMB_OK && k < w->size; k++) {
        size_t row = w->index[k];
        bool backwards = mpq_sgn(w->value[k]) < 0 && h->rel[row] != FMB_EQ;
        mpq_abs(size, w->value[k]);
        st = backwards ? add_scaled(h, &h->reverse[i], &h->reverse[row], size)
                       : fmb_weights_add(&h->reverse[i], (uint32_t)row, w->value[k], h->q->run.mem);
    }
    mpq_clear(size);
    return st;
}

static fmb_status push_row(remains *h, size_t k, int sign, fmb_sparse *list)
{
    fmb_weights w = {0};
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    fmb_status st = fmb_weights_add(&w, (uint32_t)k, one, h->q->run.mem);
    if (st == FMB_OK)
        st = derive(h, &w);
    if (st == FMB_OK)
        st = fmb_query_push(h->q, h->p, &w, SIZE_MAX, sign, list);
    fmb_weights_clear(&w, h->q->run.mem);
    mpq_clear(one);
    return st;
}

static fmb_status fill_claim(remains *h, size_t k, fmb_claim *claim)
{
    const fmb_derived *r = &h->e->row[h->e->live.row[k]];
    fmb_status st = FMB_OK;
    claim->rel = h->fate[k] == FMB_FATE_EQUALITY ? FMB_EQ : h->rel[k];
    fmb_vec_get(&r->v, (size_t)h->p->n, mpq_numref(claim->value));
    mpq_t a;
    mpq_init(a);
    for (int j = 0; st == FMB_OK && j < h->p->n; j++) {
        fmb_vec_get(&r->v, (size_t)j, mpq_numref(a));
        st = fmb_evidence_push(h->q->evidence, &claim->terms, (size_t)h->p->var[j], a);
    }
    mpq_clear(a);
    if (st == FMB_OK)
        st = push_row(h, k, 1, &claim->multipliers);
    if (st != FMB_OK || claim->rel != FMB_EQ)
        return st;
    if (h->fate[k] != FMB_FATE_EQUALITY)
        return push_row(h, k, -1, &claim->reverse);
    st = derive(h, &h->reverse[k]);
    return st == FMB_OK ? fmb_query_push(h->q, h->p, &h->reverse[k], SIZE_MAX, 1, &claim->reverse)
                        : st;
}

static fmb_status claim_row(remains *h, size_t k)
{
    fmb_claim *claim;
    if (!h->q->evidence)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(h->q->evidence, FMB_CLAIM_IMPLIED, &claim);
    if (st != FMB_OK)
        return st;
    st = fill_claim(h, k, claim);
    if (st != FMB_OK)
        fmb_evidence_drop_last(h->q->evidence);
    return st;
}

/* ---- rows out -------------------------------------------------------------------------------- */

fmb_status fmb_query_append_row(fmb_query *q, const fmb_part *p, const fmb_derived *r, fmb_rel rel,
                                const int *place, fmb_system *out)
{
    size_t n = (size_t)p->n, terms = 0;
    fmb_mem *mem = q->run.mem;
    mpz_t *z = fmb_mem_get(mem, n + 2, sizeof *z);
    int *var = fmb_mem_get(mem, n, sizeof *var);
    fmb_status st = z && var ? FMB_OK : fmb_mem_status(mem);
    for (size_t j = 0; z && j < n + 2; j++)
        mpz_init(z[j]);
    for (size_t j = 0; st == FMB_OK && j < n; j++) {
        if (fmb_vec_sgn(&r->v, j) == 0)
            continue;
        var[terms] = place[p->var[j]];
        fmb_vec_get(&r->v, j, z[terms++]);
    }
    if (st == FMB_OK) {
        fmb_vec_get(&r->v, n, z[terms]);
        mpz_set_ui(z[terms + 1], 1);
        st = fmb_system_append(out, terms, var, z, rel);
    }
    for (size_t j = 0; z && j < n + 2; j++)
        mpz_clear(z[j]);
    fmb_mem_put(mem, z, n + 2, sizeof *z);
    fmb_mem_put(mem, var, n, sizeof *var);
    return st;
}

/* Oracle row k as a row of the projection; a claim first, so that no row goes without. */
static fmb_status put_row(remains *h, size_t k)
{
    fmb_rel rel = h->fate[k] == FMB_FATE_EQUALITY ? FMB_EQ : h->rel[k];
    const fmb_derived *r = &h->e->row[h->e->live.row[k]];
    fmb_status st = claim_row(h, k);
    return st == FMB_OK ? fmb_query_append_row(h->q, h->p, r, rel, h->place, h->out) : st;
}

/* ---- what is irredundant --------------------------------------------------------------------- */

/* The rows left, as the oracle takes them. */
static fmb_status list_rows(remains *h)
{
    fmb_arena *arena = &h->q->v->arena;
    size_t m = h->e->live.size;
    h->row = fmb_arena_get(arena, m, sizeof *h->row);
    h->rel = fmb_arena_get(arena, m, sizeof *h->rel);
    h->fate = fmb_arena_get(arena, m, sizeof *h->fate);
    if (!h->row || !h->rel || !h->fate)
        return fmb_mem_status(arena->mem);
    for (size_t k = 0; k < m; k++) {
        fmb_derived *r = &h->e->row[h->e->live.row[k]];
        fmb_status st = fmb_vec_reduce(&r->v, (size_t)h->e->n + 1, &h->e->num);
        if (st != FMB_OK)
            return st;
        h->rel[k] = r->equality ? FMB_EQ : r->strict ? FMB_LT : FMB_LE;
        h->fate[k] = FMB_FATE_UNKNOWN;
        h->row[k] = (fmb_lp_row){&r->v, h->rel[k]};
    }
    return FMB_OK;
}

/* Drop the rows that are gone; note which are kept. */
static void apply_sorting(remains *h, const fmb_sorting *sorting)
{
    size_t left = 0;
    for (size_t k = 0; k < h->e->live.size; k++) {
        if (sorting->gone[k])
            continue;
        h->e->live.row[left] = h->e->live.row[k];
        h->row[left] = h->row[k];
        h->rel[left] = h->rel[k];
        h->fate[left] = sorting->kept[k] ? FMB_FATE_KEPT : FMB_FATE_UNKNOWN;
        left++;
    }
    h->e->live.size = left;
}

/* What a guess finds is cheap, and mostly all. *inner: the projection has a point strictly inside
 * its rows. */
static fmb_status sort_out(remains *h, bool *inner)
{
    fmb_mem *mem = h->q->run.mem;
    size_t m = h->e->live.size;
    fmb_sorting sorting = {.gone = fmb_mem_zero(mem, m, sizeof *sorting.gone),
                           .kept = fmb_mem_zero(mem, m, sizeof *sorting.kept)};
    fmb_status st = sorting.gone && sorting.kept ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK)
        st = fmb_lp_sort_rows(&h->q->run, h->p->n, m, h->row, &sorting);
    if (st == FMB_OK)
        apply_sorting(h, &sorting);
    *inner = sorting.inner;
    fmb_mem_put(mem, sorting.gone, m, sizeof *sorting.gone);
    fmb_mem_put(mem, sorting.kept, m, sizeof *sorting.kept);
    return st;
}

static bool is_settled(const remains *h)
{
    for (size_t k = 0; k < h->e->live.size; k++)
        if (h->fate[k] == FMB_FATE_UNKNOWN)
            return false;
    return true;
}

/* The oracle decides what is left to decide. */
static fmb_status ask_oracle_about_rows(remains *h, bool *feasible)
{
    size_t m = h->e->live.size;
    fmb_verdicts told = {NULL, note_equality, NULL, h};
    h->reverse = fmb_arena_get(&h->q->v->arena, m, sizeof *h->reverse);
    if (!h->reverse)
        return fmb_mem_status(h->q->run.mem);
    for (size_t k = 0; k < m; k++)
        h->reverse[k] = (fmb_weights){0};
    h->has_lp = true;
    fmb_status st = fmb_lp_init(&h->lp, &h->q->run, h->p->n, m, h->row, fmb_query_is_wide(h->q));
    if (st == FMB_OK)
        st = fmb_lp_feasible(&h->lp, feasible);
    if (st != FMB_OK || !*feasible)
        return st;
    return fmb_irredundant(&h->lp, h->rel, h->fate, h->q->evidence ? &told : NULL);
}

/* Put out what is irredundant. */
static fmb_status put_rows(remains *h)
{
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < h->e->live.size; k++)
        if (h->fate[k] != FMB_FATE_REDUNDANT)
            st = put_row(h, k);
    return st;
}

static void close_remains(remains *h)
{
    if (h->has_lp)
        fmb_lp_clear(&h->lp);
    for (size_t k = 0; h->reverse && k < h->e->live.size; k++)
        fmb_weights_clear(&h->reverse[k], h->q->run.mem);
}

fmb_status fmb_thin_out(fmb_query *q, const fmb_part *p, const int *place, fmb_elim *e,
                        fmb_system *out, bool *feasible)
{
    remains h = {.q = q, .p = p, .place = place, .e = e, .out = out};
    bool inner = false;
    *feasible = true;
    fmb_status st = list_rows(&h);
    if (st == FMB_OK)
        st = sort_out(&h, &inner);
    if (st == FMB_OK && !(inner && is_settled(&h)))
        st = ask_oracle_about_rows(&h, feasible);
    if (st == FMB_OK && *feasible)
        st = put_rows(&h);
    close_remains(&h);
    return st;
}
