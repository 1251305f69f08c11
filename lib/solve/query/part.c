/* part.c: connected components by union-find; see part.h. */
#include "solve/query/part.h"

#include <string.h>

#include "num/gcd.h"
#include "system/system_private.h"

static int component_root(int *up, int j)
{
    while (up[j] != j)
        j = up[j] = up[up[j]];
    return j;
}

/* up[j] becomes the least variable of j's component; used[j] whether any row names j. */
static void connect_variables(const fmb_system *s, int *up, bool *used)
{
    for (size_t i = 0; i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        int a = r->nnz > 0 ? component_root(up, r->var[0]) : 0;
        for (size_t k = 0; k < r->nnz; k++) {
            int b = component_root(up, r->var[k]), least = a < b ? a : b;
            used[r->var[k]] = true;
            up[a] = up[b] = least;
            a = least;
        }
    }
}

/* One component of all variables that a row names; or, if it names any, of all there are. */
static void join_all_variables(int *up, bool *used, size_t dim, fmb_split how)
{
    int first = -1;
    for (size_t j = 0; j < dim; j++) {
        if (!used[j])
            continue;
        first = first < 0 ? (int)j : first;
        up[j] = first;
    }
    for (size_t j = 0; how == FMB_SPLIT_ALL && first >= 0 && j < dim; j++) {
        used[j] = true;
        up[j] = 0;
    }
}

static bool is_false_constant_row(const fmb_sysrow *r)
{
    int b = fmb_vec_sgn(&r->val, 0);
    return r->rel == FMB_EQ ? b != 0 : r->rel == FMB_LT ? b <= 0 : b < 0;
}

/* Number the parts in the order of their first variables, and count variables and rows of each. */
static void number_parts(fmb_parts *p, const fmb_system *s, int *up, const bool *used)
{
    int dim = fmb_system_dim(s);
    for (int j = 0; j < dim; j++) {
        p->of_var[j] = !used[j]                     ? -1
                       : component_root(up, j) == j ? p->count++
                                                    : p->of_var[component_root(up, j)];
        if (used[j])
            p->place[j] = p->part[p->of_var[j]].n++;
    }
    for (size_t i = 0; i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        if (r->nnz > 0)
            p->part[p->of_var[r->var[0]]].m++;
        else if (p->false_row == SIZE_MAX && is_false_constant_row(r))
            p->false_row = i;
    }
}

/* Allocate n variables and m rows; m becomes 0 and then counts rows filled in. */
static fmb_status allocate_part(fmb_part *p, fmb_arena *arena)
{
    p->var = fmb_arena_get(arena, (size_t)p->n, sizeof *p->var);
    p->rel = fmb_arena_get(arena, p->m, sizeof *p->rel);
    p->source = fmb_arena_get(arena, p->m, sizeof *p->source);
    p->m = 0;
    return p->var && p->rel && p->source ? FMB_OK : fmb_mem_status(arena->mem);
}

static fmb_status list_rows_and_variables(fmb_parts *p, const fmb_system *s, fmb_run *run,
                                          fmb_arena *arena)
{
    for (int c = 0; c < p->count; c++)
        FMB_TRY(allocate_part(&p->part[c], arena));
    for (int j = 0; j < fmb_system_dim(s); j++)
        if (p->of_var[j] >= 0)
            p->part[p->of_var[j]].var[p->place[j]] = j;
    for (size_t i = 0; i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        if (r->nnz == 0)
            continue;
        fmb_part *part = &p->part[p->of_var[r->var[0]]];
        part->source[part->m] = i;
        part->rel[part->m++] = r->rel;
        FMB_TRY(fmb_run_poll(run));
    }
    return FMB_OK;
}

fmb_status fmb_parts_split(fmb_parts *p, const fmb_system *s, fmb_run *run, fmb_arena *arena,
                           fmb_split how)
{
    size_t dim = (size_t)fmb_system_dim(s);
    *p = (fmb_parts){.false_row = SIZE_MAX};
    int *up;
    FMB_TRY(FMB_ARENA_GET(arena, up, dim));
    bool *used;
    FMB_TRY(FMB_ARENA_GET(arena, used, dim));
    FMB_TRY(FMB_ARENA_GET(arena, p->of_var, dim));
    FMB_TRY(FMB_ARENA_GET(arena, p->place, dim));
    FMB_TRY(FMB_ARENA_GET(arena, p->part, dim));
    for (size_t j = 0; j < dim; j++) {
        up[j] = (int)j;
        used[j] = false;
        p->part[j] = (fmb_part){0};
    }
    connect_variables(s, up, used);
    if (how != FMB_SPLIT_COMPONENTS)
        join_all_variables(up, used, dim, how);
    number_parts(p, s, up, used);
    return list_rows_and_variables(p, s, run, arena);
}

/* ---- dense rows ------------------------------------------------------------------------------ */

static fmb_status set_wide_row(fmb_vec *v, const fmb_sysrow *r, const int *place, size_t n,
                               fmb_mem *mem)
{
    FMB_TRY(fmb_vec_widen(v, n, mem));
    for (size_t k = 0; k <= r->nnz; k++) {
        size_t at = k < r->nnz ? (size_t)place[r->var[k]] : n - 1;
        fmb_vec_get(&r->val, k, v->z[at]);
    }
    return FMB_OK;
}

/* v is all zeros. */
static fmb_status load_row_of_part(fmb_vec *v, const fmb_sysrow *r, const int *place, size_t n,
                                   fmb_num *k)
{
    if (fmb_vec_is_wide(&r->val)) {
        FMB_TRY(set_wide_row(v, r, place, n, k->mem));
    } else {
        for (size_t t = 0; t < r->nnz; t++)
            v->s[place[r->var[t]]] = r->val.s[t];
        v->s[n - 1] = r->val.s[r->nnz];
        if (!k->wide_only && fmb_content_small(r->val.s, r->nnz + 1, &v->bits) <= 1)
            return FMB_OK;
    }
    return fmb_vec_reduce(v, n, k);
}

static void unload_part(fmb_part *p, fmb_mem *mem)
{
    if (!p->row)
        return;
    for (size_t i = 0; i < p->m; i++)
        fmb_vec_clear(&p->row[i], (size_t)p->n + 1, mem);
    fmb_mem_put(mem, p->words, p->m * ((size_t)p->n + 1), sizeof *p->words);
    fmb_mem_put(mem, p->row, p->m, sizeof *p->row);
    p->row = NULL;
}

fmb_status fmb_part_load(fmb_part *p, const fmb_system *s, const int *place, fmb_run *run,
                         bool wide_only)
{
    size_t n = (size_t)p->n + 1, cells;
    fmb_num k;
    if (p->row)
        return FMB_OK;
    if (__builtin_mul_overflow(n, p->m, &cells))
        return FMB_ERR_MEMORY;
    p->row = fmb_mem_zero(run->mem, p->m, sizeof *p->row);
    p->words = p->row ? fmb_mem_zero(run->mem, cells, sizeof *p->words) : NULL;
    fmb_status st = p->words ? fmb_run_open_num(run, &k, 1, wide_only) : fmb_mem_status(run->mem);
    if (!p->words) {
        fmb_mem_put(run->mem, p->row, p->m, sizeof *p->row);
        p->row = NULL;
        return st;
    }
    for (size_t i = 0; i < p->m; i++)
        p->row[i].s = p->words + i * n;
    for (size_t i = 0; st == FMB_OK && i < p->m; i++) {
        st = load_row_of_part(&p->row[i], fmb_system_row(s, p->source[i]), place, n, &k);
        if (st == FMB_OK && run->stop == FMB_STOP_DONE)
            st = fmb_run_poll_step(run, fmb_vec_is_wide(&p->row[i]));
        p->wide |= fmb_vec_is_wide(&p->row[i]);
    }
    fmb_num_clear(&k);
    if (st != FMB_OK)
        unload_part(p, run->mem);
    return st;
}

void fmb_parts_clear(fmb_parts *p, fmb_mem *mem)
{
    for (int c = 0; c < p->count; c++)
        unload_part(&p->part[c], mem);
    p->count = 0;
}

/* ---- scale ----------------------------------------------------------------------------------- */

fmb_status fmb_part_content(const fmb_system *s, size_t source, fmb_run *run, mpz_t content)
{
    const fmb_sysrow *r = fmb_system_row(s, source);
    const fmb_poll poll = fmb_run_asked(run);
    int bits;
    fmb_integer_set_u64(content, r->val.z ? 0 : fmb_content_small(r->val.s, r->nnz + 1, &bits));
    for (size_t k = 0; r->val.z && k <= r->nnz && mpz_cmp_ui(content, 1) != 0; k++)
        FMB_TRY(fmb_long_gcd(content, content, r->val.z[k], &poll));
    return FMB_OK;
}

/* The system's row is ints / den, the part's row is ints / g, with g the greatest common divisor of
 * coefficients and right side: a multiplier u of the latter is u den / g of the former. */
fmb_status fmb_part_scale(const fmb_system *s, size_t source, fmb_run *run, mpq_t factor)
{
    const fmb_sysrow *r = fmb_system_row(s, source);
    fmb_status st = fmb_part_content(s, source, run, mpq_denref(factor));
    if (st != FMB_OK) {
        mpq_set_ui(factor, 1, 1);
        return st;
    }
    fmb_vec_get(&r->val, r->nnz + 1, mpq_numref(factor));
    mpq_canonicalize(factor);
    return FMB_OK;
}
