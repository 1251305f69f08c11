/* matrix.c: all rows of a system as one object, in compressed rows of doubles. */
#include "system/system_private.h"

/* What is handed out, with what it takes to free it. */
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
    o->start = fmb_mem_get(&o->mem, rows + 1, sizeof *o->start);
    o->var = fmb_mem_get(&o->mem, terms, sizeof *o->var);
    o->coef = fmb_mem_get(&o->mem, terms, sizeof *o->coef);
    o->b = fmb_mem_get(&o->mem, rows, sizeof *o->b);
    o->rel = fmb_mem_get(&o->mem, rows, sizeof *o->rel);
    o->shown = (fmb_matrix){rows, terms, 0, o->start, o->var, o->coef, o->rel, o->b};
    return o->start && o->var && o->coef && o->b && o->rel;
}

fmb_status fmb_system_matrix(const fmb_system *s, fmb_matrix **out)
{
    fmb_mem mem;
    if (!s || !out)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, &s->mem.alloc, 0);
    owned_matrix *o = fmb_mem_zero(&mem, 1, sizeof *o);
    if (!o)
        return FMB_ERR_MEMORY;
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
    fmb_mem_put(&o->mem, o->start, m->rows + 1, sizeof *o->start);
    fmb_mem_put(&o->mem, o->var, m->terms, sizeof *o->var);
    fmb_mem_put(&o->mem, o->coef, m->terms, sizeof *o->coef);
    fmb_mem_put(&o->mem, o->b, m->rows, sizeof *o->b);
    fmb_mem_put(&o->mem, o->rel, m->rows, sizeof *o->rel);
    fmb_mem mem = o->mem;
    fmb_mem_put(&mem, o, 1, sizeof *o);
}
