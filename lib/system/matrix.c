/* matrix.c: all rows of a system as one object, in compressed rows of doubles. */
#include "system/system_private.h"

#include "base/arrays.h"

/* The public object, with the data needed to free it. */
typedef struct owned_matrix {
    fmb_matrix shown;
    fmb_mem mem;
    size_t *start;
    int *var;
    double *coef, *b;
    fmb_rel *rel;
} owned_matrix;

static bool reserve_matrix(owned_matrix *o, size_t rows, size_t terms)
{
    bool good = FMB_ARRAYS(&o->mem, true, FMB_ARRAY(o->start, rows + 1), FMB_ARRAY(o->var, terms),
                           FMB_ARRAY(o->coef, terms), FMB_ARRAY(o->b, rows),
                           FMB_ARRAY(o->rel, rows)) == FMB_OK;
    o->shown = (fmb_matrix){rows, terms, 0, o->start, o->var, o->coef, o->rel, o->b};
    return good;
}

fmb_status fmb_system_matrix(const fmb_system *s, fmb_matrix **out)
{
    fmb_mem mem;
    if (!s || !out)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, &s->mem.alloc, 0);
    owned_matrix *o;
    FMB_TRY(FMB_GET_ZERO(&mem, o, 1));
    o->mem = mem;
    bool has_room = reserve_matrix(o, fmb_system_rows(s), fmb_system_nonzeros(s));
    o->shown.dim = fmb_system_dim(s);
    fmb_status st =
        has_room ? fmb_system_get_rows(s, 0, o->shown.rows, o->start, o->var, o->coef, o->rel, o->b)
                 : FMB_ERR_MEMORY;
    if (st == FMB_OK)
        *out = &o->shown;
    else
        fmb_matrix_free(&o->shown);
    return st;
}

void fmb_matrix_free(fmb_matrix *m)
{
    if (!m)
        return;
    owned_matrix *o = (owned_matrix *)m; /* its first member */
    FMB_ARRAYS_PUT(&o->mem, FMB_ARRAY(o->start, m->rows + 1), FMB_ARRAY(o->var, m->terms),
                   FMB_ARRAY(o->coef, m->terms), FMB_ARRAY(o->b, m->rows),
                   FMB_ARRAY(o->rel, m->rows));
    fmb_mem mem = o->mem;
    fmb_mem_put(&mem, o, 1, sizeof *o);
}
