/* cone_rows.c: see cone_rows.h. */
#include "dd/cone_rows.h"

static fmb_status make_room(fmb_cone_rows *r, fmb_arena *arena, size_t size)
{
    FMB_TRY(FMB_ARENA_GET(arena, r->row, size));
    FMB_TRY(FMB_ARENA_GET(arena, r->v, size));
    for (size_t i = 0; i < size; i++)
        r->v[i] = (fmb_vec){0};
    r->size = size;
    return FMB_OK;
}

fmb_status fmb_cone_rows_write(fmb_cone_rows *r, fmb_arena *arena, fmb_run *run, size_t d,
                               size_t size, fmb_cone_row_writer *write, const void *of)
{
    *r = (fmb_cone_rows){.d = d};
    mpz_t *z = fmb_vec_block(d, run->mem);
    if (!z)
        return fmb_mem_status(run->mem);
    fmb_status st = make_room(r, arena, size);
    for (size_t i = 0; st == FMB_OK && i < size; i++) {
        fmb_vec *v = &r->v[i];
        r->row[i] = (fmb_cone_row){.v = v};
        write(of, i, z, &r->row[i]);
        v->s = fmb_arena_get(arena, d, sizeof *v->s);
        st = v->s ? fmb_vec_set_z(v, d, z, run->mem) : fmb_mem_status(arena->mem);
        FMB_THEN(st, fmb_run_poll(run));
    }
    fmb_vec_block_free(z, d, run->mem);
    return st;
}

void fmb_cone_rows_clear(fmb_cone_rows *r, fmb_mem *mem)
{
    for (size_t i = 0; i < r->size; i++)
        fmb_vec_clear(&r->v[i], r->d, mem);
    r->size = 0;
}
