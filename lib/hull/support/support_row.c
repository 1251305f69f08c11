/* support_row.c: rows that are proved; see support.h. */
#include "hull/support/support_private.h"

/* h0 + h.x >= 0 as -h.x <= h0. */
fmb_status fmb_support_write_row(const fmb_support *s, const fmb_vec *h, fmb_support_row *row,
                                 fmb_mem *mem)
{
    FMB_TRY(fmb_integers_init(&row->z, s->k + 1, mem));
    for (size_t j = 0; j < s->k; j++) {
        fmb_vec_get(h, j + 1, row->z.z[j]);
        mpz_neg(row->z.z[j], row->z.z[j]);
    }
    fmb_vec_get(h, 0, row->z.z[s->k]);
    return fmb_integers_settle(&row->z, mem);
}

fmb_status fmb_support_keep(fmb_support *s, fmb_support_row *row)
{
    fmb_status st = FMB_RESERVE(s->run->mem, &s->row, &s->row_capacity, s->rows + 1);
    if (st == FMB_OK)
        s->row[s->rows++] = *row;
    else
        fmb_support_drop(row, s->run->mem);
    return st;
}

fmb_status fmb_support_keep_facet(fmb_support *s, size_t facet, fmb_support_row *row)
{
    fmb_support_note_facet(s, facet, row->rel);
    return fmb_support_keep(s, row);
}

void fmb_support_drop(fmb_support_row *row, fmb_mem *mem)
{
    fmb_integers_clear(&row->z, mem);
    fmb_weights_clear(&row->proof, mem);
    fmb_weights_clear(&row->reverse, mem);
}
