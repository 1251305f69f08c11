/* support_row.c: rows that are proved; see support.h. */
#include "hull/support_inside.h"

/* h0 + h.x >= 0 as -h.x <= h0. */
fmb_status fmb_support_write_row(fmb_support *s, const fmb_vec *h, fmb_support_row *row)
{
    fmb_status st = fmb_integers_init(&row->z, s->k + 1, s->run->mem);
    if (st != FMB_OK)
        return st;
    for (size_t j = 0; j < s->k; j++) {
        fmb_vec_get(h, j + 1, row->z.z[j]);
        mpz_neg(row->z.z[j], row->z.z[j]);
    }
    fmb_vec_get(h, 0, row->z.z[s->k]);
    return fmb_integers_settle(&row->z, s->run->mem);
}

fmb_status fmb_support_keep(fmb_support *s, fmb_support_row *row)
{
    fmb_status st = fmb_mem_reserve(s->run->mem, (void **)&s->row, &s->row_capacity, s->rows + 1,
                                    sizeof *s->row);
    if (st == FMB_OK)
        s->row[s->rows++] = *row;
    else
        fmb_support_drop(s, row);
    return st;
}

void fmb_support_drop(fmb_support *s, fmb_support_row *row)
{
    fmb_mem *mem = s->run->mem;
    fmb_integers_clear(&row->z, mem);
    fmb_weights_clear(&row->proof, mem);
    fmb_weights_clear(&row->reverse, mem);
}
