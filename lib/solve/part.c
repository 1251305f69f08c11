/* part.c: connected components by union-find; see part.h. */
#include "solve/part.h"

#include <string.h>

#include "system/system.h"

static int root(int *up, int j)
{
    while (up[j] != j)
        j = up[j] = up[up[j]];
    return j;
}

/* up[j] becomes the least variable of j's component; used[j] whether any row names j. */
static void connect(const fmb_system *s, int *up, bool *used)
{
    for (size_t i = 0; i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        for (size_t k = 0; k < r->nnz; k++) {
            int a = root(up, r->var[0]), b = root(up, r->var[k]);
            used[r->var[k]] = true;
            up[a > b ? a : b] = a > b ? b : a;
        }
    }
}

/* One component of all variables that a row names. */
static void join_all(int *up, const bool *used, size_t dim)
{
    int first = -1;
    for (size_t j = 0; j < dim; j++) {
        if (!used[j])
            continue;
        first = first < 0 ? (int)j : first;
        up[j] = first;
    }
}

static bool is_false(const fmb_sysrow *r)
{
    int b = fmb_vec_sgn(&r->val, 0);
    return r->rel == FMB_EQ ? b != 0 : r->rel == FMB_LT ? b <= 0 : b < 0;
}

/* Number the parts in the order of their first variables, and count variables and rows of each. */
static void count(fmb_parts *p, const fmb_system *s, int *up, const bool *used)
{
    int dim = fmb_system_dim(s);
    for (int j = 0; j < dim; j++) {
        p->of_var[j] = !used[j] ? -1 : root(up, j) == j ? p->count++ : p->of_var[root(up, j)];
        if (used[j])
            p->place[j] = p->part[p->of_var[j]].n++;
    }
    for (size_t i = 0; i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        if (r->nnz > 0)
            p->part[p->of_var[r->var[0]]].m++;
        else if (p->false_row == SIZE_MAX && is_false(r))
            p->false_row = i;
    }
}

/* Room for n variables and m rows; n and m then count what is filled in. */
static fmb_status open_part(fmb_part *p, fmb_arena *arena)
{
    size_t n = (size_t)p->n, m = p->m;
    p->var = fmb_arena_get(arena, n, sizeof *p->var);
    p->row = fmb_arena_get(arena, m, sizeof *p->row);
    p->rel = fmb_arena_get(arena, m, sizeof *p->rel);
    p->source = fmb_arena_get(arena, m, sizeof *p->source);
    p->m = 0;
    return p->var && p->row && p->rel && p->source ? FMB_OK : fmb_mem_status(arena->mem);
}

static fmb_status set_wide(fmb_vec *v, const fmb_sysrow *r, const int *place, size_t n,
                           fmb_mem *mem)
{
    fmb_status st = fmb_vec_widen(v, n, mem);
    for (size_t k = 0; st == FMB_OK && k <= r->nnz; k++) {
        size_t at = k < r->nnz ? (size_t)place[r->var[k]] : n - 1;
        fmb_vec_get(&r->val, k, v->z[at]);
    }
    return st;
}

static fmb_status load_row(fmb_part *p, const fmb_sysrow *r, const int *place, fmb_num *k,
                           fmb_arena *arena)
{
    size_t n = (size_t)p->n + 1;
    fmb_vec *v = &p->row[p->m];
    *v = (fmb_vec){.s = fmb_arena_get(arena, n, sizeof *v->s)};
    if (!v->s)
        return fmb_mem_status(arena->mem);
    p->rel[p->m] = r->rel;
    p->m++;
    memset(v->s, 0, n * sizeof *v->s);
    if (fmb_vec_is_wide(&r->val)) {
        fmb_status st = set_wide(v, r, place, n, arena->mem);
        if (st != FMB_OK)
            return st;
    } else {
        for (size_t t = 0; t < r->nnz; t++)
            v->s[place[r->var[t]]] = r->val.s[t];
        v->s[n - 1] = r->val.s[r->nnz];
    }
    return fmb_vec_reduce(v, n, k);
}

static fmb_status load(fmb_parts *p, const fmb_system *s, fmb_run *run, fmb_arena *arena,
                       fmb_num *k)
{
    fmb_status st = FMB_OK;
    for (int c = 0; st == FMB_OK && c < p->count; c++)
        st = open_part(&p->part[c], arena);
    for (int j = 0; st == FMB_OK && j < fmb_system_dim(s); j++)
        if (p->of_var[j] >= 0)
            p->part[p->of_var[j]].var[p->place[j]] = j;
    for (size_t i = 0; st == FMB_OK && i < s->rows; i++) {
        const fmb_sysrow *r = fmb_system_row(s, i);
        if (r->nnz == 0)
            continue;
        fmb_part *part = &p->part[p->of_var[r->var[0]]];
        part->source[part->m] = i;
        st = load_row(part, r, p->place, k, arena);
        if (st == FMB_OK)
            st = fmb_run_poll(run);
    }
    return st;
}

fmb_status fmb_parts_split(fmb_parts *p, const fmb_system *s, fmb_run *run, fmb_arena *arena,
                           bool wide_only, bool components)
{
    size_t dim = (size_t)fmb_system_dim(s);
    *p = (fmb_parts){.false_row = SIZE_MAX};
    int *up = fmb_arena_get(arena, dim, sizeof *up);
    bool *used = fmb_arena_get(arena, dim, sizeof *used);
    p->of_var = fmb_arena_get(arena, dim, sizeof *p->of_var);
    p->place = fmb_arena_get(arena, dim, sizeof *p->place);
    p->part = fmb_arena_get(arena, dim, sizeof *p->part);
    if (!up || !used || !p->of_var || !p->place || !p->part)
        return fmb_mem_status(arena->mem);
    for (size_t j = 0; j < dim; j++) {
        up[j] = (int)j;
        used[j] = false;
        p->part[j] = (fmb_part){0};
    }
    connect(s, up, used);
    if (!components)
        join_all(up, used, dim);
    count(p, s, up, used);
    fmb_num k;
    fmb_status st = fmb_num_init(&k, run->mem, 1, wide_only);
    if (st == FMB_OK)
        st = load(p, s, run, arena, &k);
    fmb_num_clear(&k);
    return st;
}

void fmb_parts_clear(fmb_parts *p, fmb_mem *mem)
{
    for (int c = 0; c < p->count; c++)
        for (size_t i = 0; p->part[c].row && i < p->part[c].m; i++)
            fmb_vec_clear(&p->part[c].row[i], (size_t)p->part[c].n + 1, mem);
    p->count = 0;
}

/* The row as written is ints / den, the part's row ints / g with g the greatest common divisor of
 * coefficients and right side: so a multiplier u of the latter is u den / g of the former. */
void fmb_part_scale(const fmb_system *s, size_t source, mpq_t factor)
{
    const fmb_sysrow *r = fmb_system_row(s, source);
    mpz_t t;
    mpz_init(t);
    mpz_set_ui(mpq_denref(factor), 0);
    for (size_t k = 0; k <= r->nnz; k++) {
        fmb_vec_get(&r->val, k, t);
        mpz_gcd(mpq_denref(factor), mpq_denref(factor), t);
    }
    fmb_vec_get(&r->val, r->nnz + 1, mpq_numref(factor));
    mpz_clear(t);
    mpq_canonicalize(factor);
}
