/* row.c: adds rows to the store: base rows, and combinations. */
#include "elim/store/store.h"

/* An empty row at the end of the store, not counted yet. */
static fmb_status open_row(fmb_elim *e, fmb_derived **out)
{
    FMB_TRY(FMB_ARENA_RESERVE(e->arena, &e->row, &e->row_capacity, e->rows + 1));
    if (e->rows >= FMB_NO_ROW)
        return FMB_ERR_MEMORY;
    fmb_derived *r = &e->row[e->rows];
    size_t n = (size_t)e->n + 1;
    *r = (fmb_derived){.p = FMB_NO_ROW, .q = FMB_NO_ROW, .var = -1};
    r->v.s = e->spare ? e->spare : fmb_arena_get(e->arena, n + e->var_words, sizeof *r->v.s);
    if (!r->v.s)
        return fmb_mem_status(e->arena->mem);
    r->names = (uint64_t *)(r->v.s + n);
    e->spare = NULL;
    *out = r;
    return FMB_OK;
}

/* Note the variables of a combination, which are among those of its parents. */
static void note_variables_left(const fmb_elim *e, fmb_derived *r, const fmb_derived *a,
                                const fmb_derived *b)
{
    for (size_t w = 0; w < e->var_words; w++) {
        uint64_t named = a->names[w] | b->names[w];
        for (uint64_t left = named; left != 0; left &= left - 1)
            if (fmb_vec_sgn(&r->v, 64 * w + (size_t)__builtin_ctzll(left)) == 0)
                named &= ~(left & (0 - left));
        r->names[w] = named;
    }
}

static void note_variables_of_row(const fmb_elim *e, fmb_derived *r)
{
    size_t n = (size_t)e->n;
    for (size_t w = 0; w < e->var_words; w++) {
        uint64_t named = 0;
        for (size_t j = 64 * w; j < n && j < 64 * w + 64; j++)
            named |= (uint64_t)(fmb_vec_sgn(&r->v, j) != 0) << j % 64;
        r->names[w] = named;
    }
}

void fmb_elim_forget_row(fmb_elim *e, bool keep_history)
{
    fmb_derived *r = &e->row[e->rows];
    fmb_vec_clear(&r->v, (size_t)e->n + 1, e->run->mem);
    e->spare = r->v.s;
    if (!keep_history && r->history)
        e->spare_history = r->history;
}

fmb_status fmb_list_push(fmb_elim *e, fmb_list *list, uint32_t row)
{
    FMB_TRY(FMB_ARENA_RESERVE(e->arena, &list->row, &list->capacity, list->size + 1));
    list->row[list->size++] = row;
    return FMB_OK;
}

/* Count the row at the end of the store, or forget it if something went wrong. */
static fmb_status close_row(fmb_elim *e, fmb_status st)
{
    if (st == FMB_OK)
        e->rows++;
    else
        fmb_elim_forget_row(e, false);
    return st;
}

fmb_status fmb_elim_add(fmb_elim *e, const fmb_vec *v, fmb_rel rel)
{
    fmb_derived *r = NULL;
    size_t n = (size_t)e->n + 1;
    FMB_TRY(open_row(e, &r));
    fmb_status st = fmb_vec_copy(&r->v, v, n, e->run->mem);
    if (st == FMB_OK && e->num.wide_only)
        st = fmb_vec_widen(&r->v, n, e->run->mem);
    r->strict = rel == FMB_LT;
    r->equality = rel == FMB_EQ;
    r->lowest = true;
    note_variables_of_row(e, r);
    if (st == FMB_OK && !fmb_elim_is_constant(e, r))
        st = fmb_list_push(e, &e->live, (uint32_t)e->rows);
    else if (st == FMB_OK && fmb_elim_is_false(e, r))
        e->clash = (uint32_t)e->rows;
    return close_row(e, st);
}

fmb_status fmb_elim_split(fmb_elim *e, uint32_t i)
{
    fmb_derived *r = NULL;
    size_t n = (size_t)e->n + 1;
    FMB_TRY(open_row(e, &r));
    e->row[i].equality = false;
    r->p = i;
    fmb_status st = fmb_vec_copy(&r->v, &e->row[i].v, n, e->run->mem);
    if (st == FMB_OK)
        fmb_vec_negate(&r->v, n);
    note_variables_of_row(e, r);
    FMB_THEN(st, fmb_list_push(e, &e->live, (uint32_t)e->rows));
    return close_row(e, st);
}

size_t fmb_elim_minor_bits(const fmb_elim *e)
{
    size_t all = 0;
    for (size_t j = 0; j <= (size_t)e->n; j++) {
        size_t bits = 0, named = 0;
        for (size_t i = 0; i < e->live.size; i++) {
            size_t own = fmb_vec_entry_bits(&e->row[e->live.row[i]].v, j);
            bits += own;
            named += own > 0;
        }
        all += named > 0 ? bits / named : 0;
    }
    return all;
}

/* ---- combinations ---------------------------------------------------------------------------- */

fmb_status fmb_elim_form_row(fmb_elim *e, uint32_t p, uint32_t q, int var)
{
    fmb_derived *r = NULL;
    FMB_TRY(open_row(e, &r));
    const fmb_derived *a = &e->row[p], *b = &e->row[q];
    r->p = p;
    r->q = q;
    r->var = var;
    r->strict = a->strict || b->strict;
    r->equality = a->equality && b->equality;
    fmb_status st = fmb_vec_cancel(&r->v, &a->v, &b->v, (size_t)e->n + 1, (size_t)var, &e->num);
    if (st == FMB_OK && e->budget > 0 && e->rows >= e->budget) {
        e->over_budget = true;
        st = FMB_LIMIT;
    }
    if (st != FMB_OK) {
        fmb_elim_forget_row(e, false);
        return st;
    }
    note_variables_left(e, r, a, b);
    fmb_run_count(e->run, 200 + fmb_vec_work(&r->v, (size_t)e->n + 1));
    e->run->stats.rows_made++;
    return FMB_OK;
}

fmb_status fmb_elim_derive_row(fmb_elim *e, uint32_t p, uint32_t q, int var, uint32_t *out)
{
    FMB_TRY(fmb_elim_form_row(e, p, q, var));
    *out = (uint32_t)e->rows++;
    if (fmb_elim_is_constant(e, &e->row[*out]) && fmb_elim_is_false(e, &e->row[*out]))
        e->clash = *out;
    return FMB_OK;
}
