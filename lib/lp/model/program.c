/* program.c: sparse rows; see program.h. */
#include "lp/model/program.h"

#include <string.h>

void fmb_program_init(fmb_program *p, fmb_mem *mem, int n)
{
    *p = (fmb_program){.mem = mem, .n = n};
}

static void free_held_value(fmb_program *p, size_t i)
{
    fmb_vec *v = p->own ? p->own[i] : NULL;
    if (!v)
        return;
    fmb_vec_clear(v, p->row[i].size + 1, p->mem);
    fmb_mem_put(p->mem, v->s, p->row[i].size + 1, sizeof *v->s);
    fmb_mem_put(p->mem, v, 1, sizeof *v);
}

void fmb_program_clear(fmb_program *p)
{
    for (size_t i = 0; i < p->m; i++) {
        free_held_value(p, i);
        fmb_mem_put(p->mem, p->row[i].column, p->row[i].size, sizeof(int));
    }
    if (p->own)
        fmb_mem_put(p->mem, p->own, p->own_capacity, sizeof(fmb_vec *));
    if (p->row)
        fmb_mem_put(p->mem, p->row, p->capacity, sizeof *p->row);
    fmb_program_init(p, p->mem, p->n);
}

/* Memory for one more row. */
static fmb_status reserve_row(fmb_program *p)
{
    size_t old = p->own_capacity;
    FMB_TRY(FMB_RESERVE(p->mem, &p->row, &p->capacity, p->m + 1));
    if (p->own && p->m == old) {
        FMB_TRY(FMB_RESERVE(p->mem, &p->own, &p->own_capacity, p->m + 1));
        memset(p->own + old, 0, (p->own_capacity - old) * sizeof(fmb_vec *));
    }
    return FMB_OK;
}

static void fit_row_into_doubles(fmb_program_row *r)
{
    r->shift = r->value && r->value->z ? (int)fmb_vec_most_bits(r->value, r->size + 1) : 0;
}

fmb_status fmb_program_add(fmb_program *p, size_t size, const int *var, const int *place,
                           const fmb_vec *value, fmb_rel rel)
{
    FMB_TRY(reserve_row(p));
    int *column;
    FMB_TRY(FMB_GET(p->mem, column, size));
    for (size_t k = 0; k < size; k++)
        column[k] = place ? place[var[k]] : var[k];
    p->row[p->m++] = (fmb_program_row){size, column, value, rel, false, 0};
    fit_row_into_doubles(&p->row[p->m - 1]);
    p->terms += size;
    p->any_strict = p->any_strict || rel == FMB_LT;
    return FMB_OK;
}

static fmb_status make_room_for_held(fmb_program *p)
{
    FMB_TRY(reserve_row(p));
    if (p->own)
        return FMB_OK;
    p->own = fmb_mem_zero(p->mem, p->capacity, sizeof(fmb_vec *));
    p->own_capacity = p->own ? p->capacity : 0;
    return p->own ? FMB_OK : fmb_mem_status(p->mem);
}

/* Add a row of `size` terms with memory for its value, small zeros, to be written to *value. */
static fmb_status add_held_row(fmb_program *p, size_t size, fmb_rel rel, fmb_vec **value)
{
    FMB_TRY(make_room_for_held(p));
    fmb_vec *v = fmb_mem_zero(p->mem, 1, sizeof *v);
    int64_t *words = fmb_mem_zero(p->mem, size + 1, sizeof *words);
    int *column = fmb_mem_get(p->mem, size, sizeof *column);
    if (!v || !words || !column) {
        fmb_mem_put(p->mem, v, 1, sizeof *v);
        fmb_mem_put(p->mem, words, size + 1, sizeof *words);
        fmb_mem_put(p->mem, column, size, sizeof *column);
        return fmb_mem_status(p->mem);
    }
    v->s = words;
    p->own[p->m] = v;
    p->row[p->m++] = (fmb_program_row){size, column, v, rel, false, 0};
    p->terms += size;
    p->any_strict = p->any_strict || rel == FMB_LT;
    *value = v;
    return FMB_OK;
}

/* Remove the last row. */
static void drop_last_row(fmb_program *p)
{
    size_t i = p->m - 1, size = p->row[i].size;
    free_held_value(p, i);
    if (p->own)
        p->own[i] = NULL;
    p->m--;
    fmb_mem_put(p->mem, p->row[i].column, size, sizeof(int));
    p->terms -= size;
}

void fmb_program_shorten(fmb_program *p, size_t m)
{
    while (p->m > m)
        drop_last_row(p);
}

/* Keep the last row, which was filled in with that status, or remove it after an error. */
static fmb_status finish_held_row(fmb_program *p, fmb_vec *v, fmb_status st)
{
    size_t entries = p->row[p->m - 1].size + 1;
    if (st == FMB_OK && v->z)
        st = fmb_vec_settle(v, entries, p->mem);
    else if (st == FMB_OK)
        fmb_vec_measure(v, entries);
    fit_row_into_doubles(&p->row[p->m - 1]);
    if (st != FMB_OK)
        drop_last_row(p);
    return st;
}

fmb_status fmb_program_add_copy(fmb_program *p, size_t size, const int *column,
                                const fmb_vec *value, fmb_rel rel)
{
    fmb_vec *to = NULL;
    FMB_TRY(add_held_row(p, size, rel, &to));
    memcpy(p->row[p->m - 1].column, column, size * sizeof *column);
    return finish_held_row(p, to, fmb_vec_copy(to, value, size + 1, p->mem));
}

fmb_status fmb_program_set_right(fmb_program *p, size_t i, const mpz_t b)
{
    fmb_vec *v = p->own[i];
    size_t size = p->row[i].size;
    if (!v->z && mpz_sizeinbase(b, 2) <= FMB_SMALL_BITS) {
        v->s[size] = fmb_integer_get_i64(b);
        fmb_vec_measure(v, size + 1);
        return FMB_OK;
    }
    FMB_TRY(fmb_vec_widen(v, size + 1, p->mem));
    mpz_set(v->z[size], b);
    fit_row_into_doubles(&p->row[i]);
    return fmb_vec_settle(v, size + 1, p->mem);
}

fmb_status fmb_program_add_dense(fmb_program *p, const fmb_vec *v, fmb_rel rel)
{
    size_t n = (size_t)p->n, size = 0, k = 0;
    fmb_vec *to;
    for (size_t j = 0; j < n; j++)
        size += fmb_vec_sgn(v, j) != 0;
    fmb_status st = add_held_row(p, size, rel, &to);
    if (st != FMB_OK)
        return st;
    if (fmb_vec_is_wide(v))
        st = fmb_vec_widen(to, size + 1, p->mem);
    for (size_t j = 0; st == FMB_OK && j <= n; j++) {
        if (j < n && fmb_vec_sgn(v, j) == 0)
            continue;
        if (j < n)
            p->row[p->m - 1].column[k] = (int)j;
        if (to->z)
            mpz_set(to->z[k], v->z[j]);
        else
            to->s[k] = v->s[j];
        k++;
    }
    return finish_held_row(p, to, st);
}

fmb_status fmb_program_add_integers(fmb_program *p, mpz_t *z, fmb_rel rel)
{
    size_t n = (size_t)p->n, size = 0, k = 0;
    fmb_vec *to;
    for (size_t j = 0; j < n; j++)
        size += mpz_sgn(z[j]) != 0;
    fmb_status st = add_held_row(p, size, rel, &to);
    if (st == FMB_OK)
        st = fmb_vec_widen(to, size + 1, p->mem);
    else
        return st;
    for (size_t j = 0; st == FMB_OK && j <= n; j++) {
        if (j < n && mpz_sgn(z[j]) == 0)
            continue;
        if (j < n)
            p->row[p->m - 1].column[k] = (int)j;
        mpz_set(to->z[k++], z[j]);
    }
    return finish_held_row(p, to, st);
}

fmb_status fmb_program_add_interior_row(fmb_program *p, const fmb_program *from, size_t i, int lift)
{
    const fmb_program_row *r = &from->row[i];
    if (r->rel != FMB_LT) {
        fmb_status st = fmb_program_add(p, r->size, r->column, NULL, r->value, r->rel);
        if (st == FMB_OK)
            p->row[p->m - 1].off = r->off;
        return st;
    }
    fmb_vec *to;
    fmb_status st = add_held_row(p, r->size + 1, FMB_LE, &to);
    if (st != FMB_OK)
        return st;
    fmb_program_row *row = &p->row[p->m - 1];
    if (fmb_vec_is_wide(r->value) || lift > 0)
        st = fmb_vec_widen(to, r->size + 2, p->mem);
    memcpy(row->column, r->column, r->size * sizeof *row->column);
    row->column[r->size] = p->n - 1;
    row->off = r->off;
    for (size_t k = 0; st == FMB_OK && k <= r->size; k++) {
        size_t at = k < r->size ? k : k + 1;
        if (!to->z)
            to->s[at] = r->value->s[k];
        else if (r->value->z)
            mpz_set(to->z[at], r->value->z[k]);
        else
            fmb_integer_set_i64(to->z[at], r->value->s[k]);
    }
    if (st == FMB_OK && to->z)
        mpz_setbit(to->z[r->size], (mp_bitcnt_t)lift);
    else if (st == FMB_OK)
        to->s[r->size] = 1;
    return finish_held_row(p, to, st);
}

void fmb_program_add_product(const fmb_program *p, size_t i, mpz_t *x, mpz_t to)
{
    const fmb_program_row *r = &p->row[i];
    for (size_t k = 0; k < r->size; k++) {
        if (r->value->z)
            mpz_addmul(to, r->value->z[k], x[r->column[k]]);
        else
            fmb_integer_add_product_i64(to, x[r->column[k]], r->value->s[k]);
    }
}

double fmb_program_double(const fmb_program *p, size_t i, size_t k)
{
    const fmb_vec *v = p->row[i].value;
    return v->z ? fmb_vec_entry_double(v, k, p->row[i].shift) : (double)v->s[k];
}
