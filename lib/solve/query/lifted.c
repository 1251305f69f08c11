/* lifted.c: the homogenized cone of a system; see lifted.h. */
#include "solve/query/lifted.h"

void fmb_lifted_write_form(const fmb_sysrow *r, size_t d, mpz_t *z)
{
    for (size_t k = 0; k < d; k++)
        mpz_set_ui(z[k], !r && k + 1 == d);
    for (size_t k = 0; r && k < r->nnz; k++) {
        fmb_vec_get(&r->val, k, z[r->var[k]]);
        mpz_neg(z[r->var[k]], z[r->var[k]]);
    }
    if (r)
        fmb_vec_get(&r->val, r->nnz, z[d - 1]);
}

static void write_system_row(const void *of, size_t i, mpz_t *z, fmb_cone_row *row)
{
    const fmb_lifted *h = of;
    const fmb_sysrow *r = i > 0 ? fmb_system_row(h->s, i - 1) : NULL;
    fmb_lifted_write_form(r, h->d, z);
    row->equality = r && r->rel == FMB_EQ;
    row->wanted = r && r->rel == FMB_LT;
}

static fmb_status lift_system_rows(fmb_lifted *h)
{
    fmb_arena *arena = &h->q->v->arena;
    h->d = (size_t)fmb_system_dim(h->s) + 1;
    FMB_TRY(FMB_ARENA_GET(arena, h->keep, h->d));
    for (size_t k = 0; k < h->d; k++)
        h->keep[k] = k;
    return fmb_cone_rows_write(&h->rows, arena, &h->q->run, h->d, fmb_system_rows(h->s) + 1,
                               write_system_row, h);
}

fmb_status fmb_lifted_open(fmb_lifted *h, fmb_query *q, const fmb_system *s)
{
    *h = (fmb_lifted){.q = q, .s = s};
    fmb_status st = lift_system_rows(h);
    fmb_cone_problem of = {.d = h->d,
                           .m = h->rows.size,
                           .row = h->rows.row,
                           .keeps = h->d,
                           .keep = h->keep,
                           .wide_only = fmb_query_is_wide(q),
                           .sparse_first = true};
    return st == FMB_OK ? fmb_cone_init(&h->cone, &q->run, &of) : st;
}

fmb_status fmb_lifted_run(fmb_lifted *h, uint64_t rays, bool *done)
{
    FMB_TRY(fmb_cone_run(&h->cone, rays, done));
    return *done ? fmb_image_init(&h->image, &h->q->run, &h->cone, h->d, fmb_query_is_wide(h->q))
                 : FMB_OK;
}

void fmb_lifted_close(fmb_lifted *h)
{
    fmb_cone_rows_clear(&h->rows, h->q->run.mem);
    fmb_image_clear(&h->image);
    fmb_cone_clear(&h->cone);
}
