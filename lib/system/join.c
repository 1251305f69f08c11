/* join.c: appends the rows of one system to another. */
#include "system/system_private.h"

typedef struct joiner {
    fmb_system *s;
    const fmb_system *more;
    const int *map; /* or NULL */
    int *var;       /* [most] */
    mpq_t *coef;    /* [most] */
    size_t most;    /* terms of a row of more */
    mpq_t rhs;
} joiner;

static fmb_status append_copy_of_row(joiner *j, size_t i)
{
    size_t n = fmb_system_terms(j->more, i);
    for (size_t k = 0; k < n; k++) {
        int v = fmb_system_term_q(j->more, i, k, j->coef[k]);
        j->var[k] = j->map ? j->map[v] : v;
    }
    fmb_system_rhs_q(j->more, i, j->rhs);
    fmb_status st = fmb_system_add_q(j->s, n, j->var, j->coef, fmb_system_rel(j->more, i), j->rhs);
    if (st == FMB_OK)
        j->s->row[j->s->rows - 1].turned = j->more->row[i].turned;
    const char *label = fmb_system_label(j->more, i);
    return st == FMB_OK && label ? fmb_system_set_label(j->s, j->s->rows - 1, label) : st;
}

/* All rows or none. */
static fmb_status append_copies_of_rows(joiner *j)
{
    size_t before = j->s->rows, rows = j->more->rows;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < rows; i++)
        st = append_copy_of_row(j, i);
    while (st != FMB_OK && j->s->rows > before)
        fmb_system_remove(j->s, j->s->rows - 1);
    for (int v = 0; st == FMB_OK && v < fmb_system_dim(j->more); v++)
        j->s->mark[j->map ? j->map[v] : v].integer |= j->more->mark[v].integer;
    return st;
}

/* Is the place in s of every variable of more valid? */
static fmb_status check_map(fmb_system *s, const fmb_system *more, const int *var)
{
    int dim = fmb_system_dim(s), most = fmb_system_dim(more);
    if (!s || !more)
        return fmb_system_refuse(s, "a system to join that is NULL");
    if (!var && most > dim)
        return fmb_system_refuse(s, "a system over %d variables to join one over %d", most, dim);
    for (int v = 0; var && v < most; v++)
        if (var[v] < 0 || var[v] >= dim)
            return fmb_system_refuse(s, "variable %d is to be %d of a system that has %d", v,
                                     var[v], dim);
    return FMB_OK;
}

fmb_status fmb_system_join(fmb_system *s, const fmb_system *more, const int *var)
{
    joiner j = {.s = s, .more = more, .map = var};
    FMB_TRY(check_map(s, more, var));
    for (size_t i = 0; i < more->rows; i++)
        j.most = more->row[i].nnz > j.most ? more->row[i].nnz : j.most;
    j.var = fmb_mem_get(&s->mem, j.most, sizeof *j.var);
    j.coef = fmb_mem_get(&s->mem, j.most, sizeof *j.coef);
    for (size_t k = 0; j.coef && k < j.most; k++)
        mpq_init(j.coef[k]);
    mpq_init(j.rhs);
    fmb_status st = j.var && j.coef ? append_copies_of_rows(&j) : fmb_mem_status(&s->mem);
    mpq_clear(j.rhs);
    for (size_t k = 0; j.coef && k < j.most; k++)
        mpq_clear(j.coef[k]);
    fmb_mem_put(&s->mem, j.coef, j.most, sizeof *j.coef);
    fmb_mem_put(&s->mem, j.var, j.most, sizeof *j.var);
    return st;
}
