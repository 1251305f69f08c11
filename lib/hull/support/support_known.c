/* support_known.c: facets of the hull that are rows of the program; see support.h. */
#include "base/arena.h"
#include "hull/support/support_private.h"

#define NO_ROW UINT32_MAX

struct fmb_known {
    fmb_num num;
    fmb_arena arena;
    fmb_vec *row; /* [rows] as normals of facets */
    size_t rows;
    uint32_t *table; /* [mask + 1] of rows, by hash */
    size_t mask;
};

/* a.x <= b as (b, -a), coprime: v[n + 1]. */
static fmb_status write_row_as_normal(fmb_known *w, const fmb_program *p, size_t i, fmb_vec *v)
{
    const fmb_program_row *r = &p->row[i];
    size_t n = (size_t)p->n;
    mpz_t *z = fmb_vec_block(n + 1, w->num.mem);
    if (!z)
        return fmb_mem_status(w->num.mem);
    fmb_program_get(p, i, r->size, z[0]);
    for (size_t k = 0; k < r->size; k++) {
        fmb_program_get(p, i, k, z[r->column[k] + 1]);
        mpz_neg(z[r->column[k] + 1], z[r->column[k] + 1]);
    }
    fmb_status st = fmb_vec_set_z(v, n + 1, z, w->num.mem);
    fmb_vec_block_free(z, n + 1, w->num.mem);
    return st == FMB_OK ? fmb_vec_reduce(v, n + 1, &w->num) : st;
}

static size_t find_place_in_table(const fmb_known *w, const fmb_vec *v, size_t n)
{
    size_t at = (size_t)fmb_vec_hash(v, n) & w->mask;
    while (w->table[at] != NO_ROW && !fmb_vec_equal(&w->row[w->table[at]], v, n))
        at = (at + 1) & w->mask;
    return at;
}

static fmb_status know_row(fmb_support *s, const fmb_program *p, size_t i)
{
    fmb_known *w = s->known;
    size_t n = (size_t)p->n + 1;
    fmb_vec *v = &w->row[w->rows];
    *v = (fmb_vec){.s = fmb_arena_get(&w->arena, n, sizeof *v->s)};
    if (!v->s)
        return fmb_mem_status(s->run->mem);
    w->rows++;
    FMB_TRY(write_row_as_normal(w, p, i, v));
    w->table[find_place_in_table(w, v, n)] = (uint32_t)(w->rows - 1);
    return fmb_run_poll(s->run);
}

fmb_status fmb_support_know_rows(fmb_support *s, const fmb_program *p)
{
    fmb_mem *mem = s->run->mem;
    fmb_known *w;
    FMB_TRY(FMB_GET_ZERO(mem, w, 1));
    s->known = w;
    fmb_arena_init(&w->arena, mem);
    for (w->mask = 15; w->mask < 2 * p->m; w->mask = 2 * w->mask + 1)
        ;
    FMB_TRY(FMB_ARENA_GET(&w->arena, w->row, p->m));
    FMB_TRY(FMB_ARENA_GET(&w->arena, w->table, w->mask + 1));
    for (size_t at = 0; at <= w->mask; at++)
        w->table[at] = NO_ROW;
    FMB_TRY(fmb_run_open_num(s->run, &w->num, (size_t)p->n + 1, false));
    for (size_t i = 0; i < p->m; i++)
        FMB_TRY(know_row(s, p, i));
    return FMB_OK;
}

void fmb_support_forget_rows(fmb_support *s)
{
    fmb_known *w = s->known;
    if (!w)
        return;
    for (size_t i = 0; i < w->rows; i++)
        fmb_vec_clear(&w->row[i], s->k + 1, s->run->mem);
    fmb_num_clear(&w->num);
    fmb_arena_clear(&w->arena);
    fmb_mem_put(s->run->mem, w, 1, sizeof *w);
    s->known = NULL;
}

bool fmb_support_is_known(const fmb_support *s, const fmb_vec *normal)
{
    return s->known && s->known->table[find_place_in_table(s->known, normal, s->k + 1)] != NO_ROW;
}
