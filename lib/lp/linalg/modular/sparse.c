/* sparse.c: square sparse matrices of integers; see sparse.h. */
#include "lp/linalg/modular/sparse.h"

#include <math.h>

#include "num/gcd.h"

static fmb_status allocate_sparse(fmb_sparse *s, fmb_arena *arena, size_t n, size_t terms, bool big)
{
    *s = (fmb_sparse){.n = n};
    s->start = fmb_arena_get(arena, n + 1, sizeof *s->start);
    s->index = fmb_arena_get(arena, terms, sizeof *s->index);
    s->value = fmb_arena_get(arena, terms, sizeof *s->value);
    s->bits = fmb_arena_get(arena, n, sizeof *s->bits);
    if (big)
        s->big = fmb_arena_get(arena, terms, sizeof(mpz_srcptr));
    if (!s->start || !s->index || !s->value || !s->bits || (big && !s->big))
        return fmb_mem_status(arena->mem);
    s->start[0] = 0;
    return FMB_OK;
}

/* Bound the sum of |entries| of row k. */
static void measure_sparse_row(fmb_sparse *s, size_t k)
{
    fmb_u128 small = fmb_u128_of(0);
    size_t large = 0, count = s->start[k + 1] - s->start[k];
    for (size_t t = s->start[k]; t < s->start[k + 1]; t++)
        if (s->big && s->big[t]) {
            size_t bits = mpz_sizeinbase(s->big[t], 2);
            large = bits > large ? bits : large;
        } else {
            small = fmb_u128_plus_word(small, fmb_abs64(s->value[t]));
        }
    uint32_t bits = (uint32_t)fmb_u128_bits(small);
    if (large > 0) /* at most 2^bits in all */
        bits = (uint32_t)(large > bits ? large : bits) + (uint32_t)fmb_bits64(count);
    s->bits[k] = bits;
    s->bits_max = bits > s->bits_max ? bits : s->bits_max;
}

static void gather_row_terms(fmb_sparse *s, size_t at, const fmb_program_row *row)
{
    const fmb_vec *v = row->value;
    for (size_t k = 0; k < row->size; k++) {
        bool wide = v->z && mpz_sizeinbase(v->z[k], 2) > FMB_SMALL_BITS;
        s->index[at + k] = row->column[k];
        s->value[at + k] = !v->z ? v->s[k] : wide ? 0 : fmb_integer_get_i64(v->z[k]);
        if (s->big)
            s->big[at + k] = wide ? v->z[k] : NULL;
    }
}

fmb_status fmb_sparse_gather(fmb_sparse *s, fmb_arena *arena, const fmb_program *p,
                             const size_t *basis)
{
    size_t n = (size_t)p->n, terms = 0;
    bool big = false;
    for (size_t r = 0; r < n; r++) {
        terms += basis[r] < p->m ? p->row[basis[r]].size : 1;
        big = big || (basis[r] < p->m && p->row[basis[r]].value->z);
    }
    fmb_status st = allocate_sparse(s, arena, n, terms, big);
    for (size_t r = 0; st == FMB_OK && r < n; r++) {
        size_t at = s->start[r];
        if (basis[r] < p->m) {
            gather_row_terms(s, at, &p->row[basis[r]]);
            s->start[r + 1] = at + p->row[basis[r]].size;
        } else {
            s->index[at] = (int)(basis[r] - p->m);
            s->value[at] = 1;
            if (big)
                s->big[at] = NULL;
            s->start[r + 1] = at + 1;
        }
        measure_sparse_row(s, r);
    }
    return st;
}

fmb_status fmb_sparse_permute(const fmb_sparse *s, fmb_arena *arena, const int *row_at,
                              const int *column_place, fmb_sparse *to)
{
    fmb_status st = allocate_sparse(to, arena, s->n, s->start[s->n], s->big != NULL);
    for (size_t k = 0, at = 0; st == FMB_OK && k < s->n; k++) {
        size_t i = (size_t)row_at[k];
        for (size_t t = s->start[i]; t < s->start[i + 1]; t++, at++) {
            to->index[at] = column_place[s->index[t]];
            to->value[at] = s->value[t];
            if (s->big)
                to->big[at] = s->big[t];
        }
        to->start[k + 1] = at;
        to->bits[k] = s->bits[i];
    }
    to->bits_max = s->bits_max;
    return st;
}

fmb_status fmb_sparse_transpose(const fmb_sparse *s, fmb_arena *arena, fmb_sparse *to)
{
    size_t n = s->n;
    FMB_TRY(allocate_sparse(to, arena, n, s->start[n], s->big != NULL));
    for (size_t k = 0; k <= n; k++)
        to->start[k] = 0;
    for (size_t t = 0; t < s->start[n]; t++)
        to->start[s->index[t]]++;
    for (size_t k = 1; k <= n; k++)
        to->start[k] += to->start[k - 1];
    for (size_t i = n; i-- > 0;)
        for (size_t t = s->start[i]; t < s->start[i + 1]; t++) {
            size_t at = --to->start[s->index[t]];
            to->index[at] = (int)i;
            to->value[at] = s->value[t];
            if (s->big)
                to->big[at] = s->big[t];
        }
    for (size_t k = 0; k < n; k++)
        measure_sparse_row(to, k);
    return FMB_OK;
}

double fmb_sparse_determinant_bits(const fmb_sparse *s)
{
    double sum = 0;
    for (size_t k = 0; k < s->n; k++)
        sum += s->bits[k];
    return sum;
}
