/* lifted.c: the cone over the solutions of a system; see lifted.h. */
#include "solve/query/lifted.h"

#include "system/system_private.h"

/* a.x <= b as b t - a.x >= 0; z[d]. */
static fmb_status lift_system_row(fmb_lifted *h, size_t i, mpz_t *z)
{
    const fmb_sysrow *r = i > 0 ? fmb_system_row(h->s, i - 1) : NULL;
    fmb_vec *v = &h->v[i];
    v->s = fmb_arena_get(&h->q->v->arena, h->d, sizeof *v->s);
    if (!v->s)
        return fmb_mem_status(h->q->run.mem);
    for (size_t k = 0; k < h->d; k++)
        mpz_set_ui(z[k], r ? 0 : k + 1 == h->d);
    for (size_t k = 0; r && k < r->nnz; k++) {
        fmb_vec_get(&r->val, k, z[r->var[k]]);
        mpz_neg(z[r->var[k]], z[r->var[k]]);
    }
    if (r)
        fmb_vec_get(&r->val, r->nnz, z[h->d - 1]);
    h->row[i] =
        (fmb_cone_row){.v = v, .equality = r && r->rel == FMB_EQ, .wanted = r && r->rel == FMB_LT};
    fmb_status st = fmb_vec_set_z(v, h->d, z, h->q->run.mem);
    return st == FMB_OK ? fmb_run_poll(&h->q->run) : st;
}

static fmb_status lift_system_rows(fmb_lifted *h)
{
    fmb_arena *arena = &h->q->v->arena;
    fmb_mem *mem = h->q->run.mem;
    size_t rows = fmb_system_rows(h->s) + 1;
    h->d = (size_t)fmb_system_dim(h->s) + 1;
    h->row = fmb_arena_get(arena, rows, sizeof *h->row);
    h->v = fmb_arena_get(arena, rows, sizeof *h->v);
    h->keep = fmb_arena_get(arena, h->d, sizeof *h->keep);
    mpz_t *z = h->row && h->v && h->keep ? fmb_vec_block(h->d, mem) : NULL;
    if (!z)
        return fmb_mem_status(mem);
    for (size_t i = 0; i < rows; i++)
        h->v[i] = (fmb_vec){0};
    h->rows = rows;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < rows; i++)
        st = lift_system_row(h, i, z);
    for (size_t k = 0; k < h->d; k++) {
        h->keep[k] = k;
        mpz_clear(z[k]);
    }
    fmb_mem_put(mem, z, h->d, sizeof *z);
    return st;
}

fmb_status fmb_lifted_open(fmb_lifted *h, fmb_query *q, const fmb_system *s)
{
    *h = (fmb_lifted){.q = q, .s = s};
    fmb_status st = lift_system_rows(h);
    fmb_cone_problem of = {.d = h->d,
                           .m = h->rows,
                           .row = h->row,
                           .keeps = h->d,
                           .keep = h->keep,
                           .wide_only = fmb_query_is_wide(q),
                           .sparse_first = true};
    return st == FMB_OK ? fmb_cone_init(&h->cone, &q->run, &of) : st;
}

fmb_status fmb_lifted_run(fmb_lifted *h, uint64_t rays, bool *done)
{
    fmb_status st = fmb_cone_run(&h->cone, rays, done);
    return st == FMB_OK && *done
               ? fmb_image_init(&h->image, &h->q->run, &h->cone, fmb_query_is_wide(h->q))
               : st;
}

void fmb_lifted_close(fmb_lifted *h)
{
    for (size_t i = 0; i < h->rows; i++)
        fmb_vec_clear(&h->v[i], h->d, h->q->run.mem);
    fmb_image_clear(&h->image);
    fmb_cone_clear(&h->cone);
}
