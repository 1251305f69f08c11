/* nonzero_columns.c: rows in the columns that some of them name; see nonzero_columns.h. */
#include "lp/redundancy/active_set/nonzero_columns.h"

static bool is_column_nonzero_in_rows(size_t j, size_t m, const fmb_lp_row *row)
{
    for (size_t i = 0; i < m; i++)
        if (row[i].v->s[j] != 0)
            return true;
    return false;
}

/* column[0..n]: those, and the right side. */
static void copy_entries_of_columns(fmb_nonzero_columns *t, const size_t *column,
                                    const fmb_lp_row *row)
{
    size_t d = t->n + 1;
    for (size_t i = 0; i < t->m; i++) {
        int64_t *s = &t->entry[i * d];
        for (size_t k = 0; k < d; k++)
            s[k] = row[i].v->s[column[k]];
        t->v[i] = (fmb_vec){.s = s, .bits = row[i].v->bits};
        t->row[i] = (fmb_lp_row){&t->v[i], row[i].rel};
    }
}

fmb_status fmb_nonzero_columns_open(fmb_nonzero_columns *t, fmb_mem *mem, size_t n, size_t m,
                                    const fmb_lp_row *row)
{
    *t = (fmb_nonzero_columns){.mem = mem, .m = m};
    size_t *column = fmb_mem_get(mem, n + 1, sizeof *column);
    if (!column)
        return fmb_mem_status(mem);
    for (size_t j = 0; j < n; j++)
        if (is_column_nonzero_in_rows(j, m, row))
            column[t->n++] = j;
    column[t->n] = n;
    t->row = fmb_mem_get(mem, m, sizeof *t->row);
    t->v = fmb_mem_get(mem, m, sizeof *t->v);
    t->entry = fmb_mem_get(mem, m * (t->n + 1), sizeof *t->entry);
    bool got = t->row && t->v && t->entry;
    if (got)
        copy_entries_of_columns(t, column, row);
    fmb_mem_put(mem, column, n + 1, sizeof *column);
    return got ? FMB_OK : fmb_mem_status(mem);
}

void fmb_nonzero_columns_clear(fmb_nonzero_columns *t)
{
    fmb_mem_put(t->mem, t->row, t->m, sizeof *t->row);
    fmb_mem_put(t->mem, t->v, t->m, sizeof *t->v);
    fmb_mem_put(t->mem, t->entry, t->m * (t->n + 1), sizeof *t->entry);
}
