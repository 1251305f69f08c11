/* change.c: removes rows, and puts them back; see system_private.h. */
#include <string.h>

#include "num/rationals.h"
#include "system/system_private.h"

void fmb_system_take_row(fmb_system *s, size_t i, fmb_sysrow *out)
{
    *out = s->row[i];
    s->rows--;
    memmove(&s->row[i], &s->row[i + 1], (s->rows - i) * sizeof *s->row);
}

void fmb_system_put_row(fmb_system *s, size_t i, const fmb_sysrow *r)
{
    memmove(&s->row[i + 1], &s->row[i], (s->rows - i) * sizeof *s->row);
    s->row[i] = *r;
    s->rows++;
}

void fmb_system_drop_last_variable(fmb_system *s)
{
    fmb_names_drop_last(&s->names, &s->mem);
}

fmb_status fmb_system_change_right(fmb_system *s, size_t i, const mpq_t b, fmb_sysrow *old)
{
    mpq_t *coef;
    size_t n = s->row[i].nnz;
    fmb_sysrow changed;
    FMB_TRY(fmb_rationals_new(&coef, n + 1, &s->mem));
    mpq_set(coef[n], b);
    if (s->row[i].turned)
        mpq_neg(coef[n], coef[n]);
    for (size_t k = 0; k < n; k++)
        fmb_sysrow_get_q(&s->row[i], k, coef[k]);
    fmb_status st = fmb_system_add_q(s, n, s->row[i].var, coef, s->row[i].rel, coef[n]);
    fmb_rationals_free(coef, n + 1, &s->mem);
    if (st != FMB_OK)
        return st;
    fmb_system_take_row(s, s->rows - 1, &changed);
    *old = s->row[i];
    s->row[i] = changed;
    s->row[i].label = old->label;
    s->row[i].turned = old->turned;
    old->label = NULL;
    return FMB_OK;
}
