/* pruner.c: see pruner.h. */
#include "lp/redundancy/pruner.h"

#include "base/arrays.h"
#include "num/rationals.h"

/* ---- life ------------------------------------------------------------------------------------ */

void fmb_pruner_clear(fmb_pruner *p)
{
    fmb_mem *mem = p->run->mem;
    fmb_oracle_free(p->over_all);
    fmb_oracle_free(p->over_equal);
    fmb_program_clear(&p->all);
    fmb_program_clear(&p->equal);
    fmb_weights_clear(&p->form, mem);
    fmb_weights_clear(&p->w, mem);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(p->equality, p->m), FMB_ARRAY(p->term, p->m),
                   FMB_ARRAY(p->is_nonzero, p->n));
    fmb_integers_clear(&p->point, mem);
    fmb_rationals_free(p->inner, p->n, mem);
    fmb_rationals_free(p->x, p->n, mem);
    mpz_clears(p->den, p->sum, NULL);
}

static fmb_status load_all_rows(fmb_pruner *p)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < p->m; i++) {
        st = fmb_program_add_dense(&p->all, p->row[i].v, p->row[i].rel);
        if (st == FMB_OK)
            p->all.row[i].off = p->fate[i] == FMB_FATE_REDUNDANT;
    }
    p->any_strict = p->all.any_strict;
    FMB_THEN(st, fmb_oracle_new(p->run, &p->all, &p->over_all));
    return st == FMB_OK ? fmb_oracle_new(p->run, &p->equal, &p->over_equal) : st;
}

fmb_status fmb_pruner_open(fmb_pruner *p)
{
    fmb_mem *mem = p->run->mem;
    fmb_program_init(&p->all, mem, (int)p->n);
    fmb_program_init(&p->equal, mem, (int)p->n);
    mpz_inits(p->den, p->sum, NULL);
    FMB_TRY(FMB_ARRAYS(mem, true, FMB_ARRAY(p->equality, p->m), FMB_ARRAY(p->term, p->m),
                       FMB_ARRAY_ZERO(p->is_nonzero, p->n)));
    FMB_TRY(fmb_integers_init(&p->point, p->n, mem));
    FMB_TRY(fmb_rationals_new(&p->inner, p->n, mem));
    FMB_TRY(fmb_rationals_new(&p->x, p->n, mem));
    return load_all_rows(p);
}

fmb_status fmb_pruner_write_form(fmb_pruner *p, size_t i)
{
    const fmb_program_row *r = &p->all.row[i];
    fmb_status st = FMB_OK;
    mpq_t a;
    mpq_init(a);
    fmb_weights_clear(&p->form, p->run->mem);
    for (size_t k = 0; st == FMB_OK && k < r->size; k++) {
        fmb_vec_get_q(r->value, k, a);
        st = fmb_weights_add(&p->form, (uint32_t)r->column[k], a, p->run->mem);
    }
    mpq_clear(a);
    return st;
}

/* Report row i to `whom` with the multipliers of the last optimum (pruner.h: fmb_pruner_drop). */
static fmb_status tell_with_weights(fmb_pruner *p, const fmb_oracle *o, size_t i,
                                    const size_t *place,
                                    fmb_status (*whom)(void *, size_t, const fmb_weights *))
{
    if (!whom)
        return FMB_OK;
    fmb_weights_clear(&p->w, p->run->mem);
    fmb_status st = fmb_oracle_multipliers(o, &p->w);
    for (size_t k = 0; place && k < p->w.size; k++)
        p->w.index[k] = (uint32_t)place[p->w.index[k]];
    return st == FMB_OK ? whom(p->told->self, i, &p->w) : st;
}

void fmb_pruner_leave_out(fmb_pruner *p, size_t i)
{
    p->all.row[i].off = true;
    fmb_oracle_switch(p->over_all, i, false);
}

void fmb_pruner_take_in(fmb_pruner *p, size_t i)
{
    p->all.row[i].off = false;
    fmb_oracle_switch(p->over_all, i, true);
}

fmb_status fmb_pruner_drop(fmb_pruner *p, const fmb_oracle *o, size_t i, const size_t *place)
{
    p->fate[i] = FMB_FATE_REDUNDANT;
    fmb_pruner_leave_out(p, i);
    return tell_with_weights(p, o, i, place, p->told ? p->told->redundant : NULL);
}
