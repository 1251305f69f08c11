/* irredundant_rows.c: the irredundant ones among the live rows of an elimination; see
 * irredundant_rows.h.
 *
 * Most rows are decided by guesses that are proved at once (lp/redundancy/active_set/implied.h);
 * the oracle decides the others, and finds the implicit equalities.
 */
#include "solve/prepare/irredundant_rows.h"

#include <string.h>

#include "elim/store/derive.h"
#include "lp/redundancy/irredundant.h"
#include "solve/prepare/substituted_rows.h"

/* The live rows and their fates. Row k of the oracle is row e->live[k] of the store. */
typedef struct remains {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for eliminated variables */
    fmb_elim *e;
    fmb_system *out;
    fmb_lp_row *row;      /* [lives] */
    fmb_rel *rel;         /* [lives] */
    fmb_fate *fate;       /* [lives] */
    fmb_weights *reverse; /* [lives] multipliers of oracle rows that prove rows equalities */
} remains;

/* ---- evidence -------------------------------------------------------------------------------- */

/* Convert weights of oracle rows into weights of the part's rows. */
static fmb_status derive_from_oracle_rows(const remains *h, fmb_weights *w)
{
    for (size_t i = 0; i < w->size; i++)
        w->index[i] = h->e->live.row[w->index[i]];
    return fmb_elim_derive(h->e, w);
}

static fmb_status add_scaled_weights(remains *h, fmb_weights *sum, const fmb_weights *w,
                                     mpq_srcptr factor)
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

/* The oracle may have used the reverse of a row that it proved to be an equality: replace the
 * reverse by the multipliers that prove it. */
static fmb_status note_equality_proof(void *self, size_t i, const fmb_weights *w)
{
    remains *h = self;
    fmb_status st = FMB_OK;
    mpq_t size;
    mpq_init(size);
    for (size_t k = 0; st == FMB_OK && k < w->size; k++) {
        size_t row = w->index[k];
        bool backwards = mpq_sgn(w->value[k]) < 0 && h->rel[row] != FMB_EQ;
        mpq_abs(size, w->value[k]);
        st = backwards ? add_scaled_weights(h, &h->reverse[i], &h->reverse[row], size)
                       : fmb_weights_add(&h->reverse[i], (uint32_t)row, w->value[k], h->q->run.mem);
    }
    mpq_clear(size);
    return st;
}

/* Append oracle row k to the projection. */
static fmb_status put_irredundant_row(remains *h, size_t k)
{
    uint32_t r = h->e->live.row[k];
    if (h->fate[k] != FMB_FATE_EQUALITY)
        return fmb_query_put_row(h->q, h->p, h->e, r, h->rel[k], NULL, h->place, h->out);
    fmb_weights *reverse = &h->reverse[k];
    fmb_status st = derive_from_oracle_rows(h, reverse);
    return st == FMB_OK ? fmb_query_put_row(h->q, h->p, h->e, r, FMB_EQ, reverse, h->place, h->out)
                        : st;
}

/* ---- what is irredundant --------------------------------------------------------------------- */

/* List the live rows for the oracle. */
static fmb_status list_live_rows(remains *h)
{
    fmb_arena *arena = &h->q->v->arena;
    size_t m = h->e->live.size;
    FMB_TRY(FMB_ARENA_GET(arena, h->row, m));
    FMB_TRY(FMB_ARENA_GET(arena, h->rel, m));
    FMB_TRY(FMB_ARENA_GET(arena, h->fate, m));
    for (size_t k = 0; k < m; k++) {
        fmb_derived *r = &h->e->row[h->e->live.row[k]];
        if (!r->lowest)
            FMB_TRY(fmb_vec_reduce(&r->v, (size_t)h->e->n + 1, &h->e->num));
        r->lowest = true;
        h->rel[k] = fmb_derived_rel(r);
        h->fate[k] = FMB_FATE_UNKNOWN;
        h->row[k] = (fmb_lp_row){&r->v, h->rel[k]};
    }
    return FMB_OK;
}

/* Drop the redundant rows; note which are kept, and which of these as equalities. */
static void apply_sorting(remains *h, const fmb_sorting *sorting, const bool *tight)
{
    size_t left = 0;
    for (size_t k = 0; k < h->e->live.size; k++) {
        if (sorting->gone[k])
            continue;
        h->e->live.row[left] = h->e->live.row[k];
        h->rel[left] = tight[k] ? FMB_EQ : h->rel[k];
        h->row[left] = (fmb_lp_row){h->row[k].v, h->rel[left]};
        h->fate[left] = sorting->kept[k] ? FMB_FATE_KEPT : FMB_FATE_UNKNOWN;
        left++;
    }
    h->e->live.size = left;
}

/* Decide rows by guesses, which are cheap and mostly decide all. *inner: the projection has a
 * strictly interior point. Where claims are wanted, implicit equalities stay inequalities here, as
 * their claim needs the oracle. */
static fmb_status sort_rows_by_guess(remains *h, bool known, bool *feasible, bool *inner)
{
    size_t m = h->e->live.size;
    bool *tight;
    FMB_TRY(FMB_ARENA_GET(&h->q->v->arena, tight, 3 * m));
    memset(tight, 0, 3 * m * sizeof *tight);
    fmb_sorting sorting = {.gone = tight + m, .kept = tight + 2 * m, .known = known};
    FMB_TRY(fmb_substituted_rows_sort(&h->q->run, &h->q->v->arena, &h->e->num, (size_t)h->p->n, m,
                                      h->row, &sorting, h->q->claims ? NULL : tight));
    apply_sorting(h, &sorting, tight);
    *inner = sorting.inner;
    *feasible = sorting.feasible;
    return FMB_OK;
}

static bool are_all_fates_known(const remains *h)
{
    for (size_t k = 0; k < h->e->live.size; k++)
        if (h->fate[k] == FMB_FATE_UNKNOWN)
            return false;
    return true;
}

/* Let the oracle decide the undecided rows. */
static fmb_status ask_oracle_about_rows(remains *h, bool *feasible)
{
    size_t m = h->e->live.size;
    fmb_verdicts told = {NULL, note_equality_proof, NULL, h};
    FMB_TRY(FMB_ARENA_GET(&h->q->v->arena, h->reverse, m));
    for (size_t k = 0; k < m; k++)
        h->reverse[k] = (fmb_weights){0};
    return fmb_irredundant(&h->q->run, (size_t)h->p->n, m, h->row, h->fate,
                           h->q->claims ? &told : NULL, feasible);
}

/* Append the irredundant rows. */
static fmb_status put_irredundant_rows(remains *h)
{
    for (size_t k = 0; k < h->e->live.size; k++)
        if (h->fate[k] != FMB_FATE_REDUNDANT)
            FMB_TRY(put_irredundant_row(h, k));
    return FMB_OK;
}

static void close_remains(remains *h)
{
    for (size_t k = 0; h->reverse && k < h->e->live.size; k++)
        fmb_weights_clear(&h->reverse[k], h->q->run.mem);
}

fmb_status fmb_irredundant_rows_append(fmb_query *q, const fmb_part *p, const int *place,
                                       fmb_elim *e, bool known, fmb_system *out, bool *feasible)
{
    remains h = {.q = q, .p = p, .place = place, .e = e, .out = out};
    bool inner = false;
    if (e->live.size == 0)
        return FMB_OK;
    fmb_status st = list_live_rows(&h);
    FMB_THEN(st, sort_rows_by_guess(&h, known, feasible, &inner));
    if (st == FMB_OK && *feasible && !(inner && are_all_fates_known(&h)))
        st = ask_oracle_about_rows(&h, feasible);
    if (st == FMB_OK && *feasible)
        st = put_irredundant_rows(&h);
    close_remains(&h);
    return st;
}
