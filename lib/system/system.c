/* system.c: life of a system, its variables and labels; see system_private.h. */
#include "system/system_private.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static fmb_status add_default_name(fmb_system *s);

/* ---- error messages ------------------------------------------------------------------------- */

fmb_status fmb_system_refuse(fmb_system *s, const char *format, ...)
{
    va_list args;
    if (!s)
        return FMB_ERR_ARG;
    va_start(args, format);
    vsnprintf(s->error, sizeof s->error, format, args);
    va_end(args);
    return FMB_ERR_ARG;
}

static fmb_status refuse_variable(fmb_system *s, int j)
{
    return fmb_system_refuse(s, "variable %d of a system that has %d", j, fmb_system_dim(s));
}

static fmb_status refuse_row(fmb_system *s, size_t i)
{
    return fmb_system_refuse(s, "row %zu of a system that has %zu", i, fmb_system_rows(s));
}

const char *fmb_system_trouble(const fmb_system *s)
{
    return s ? s->error : "";
}

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_system_new(int dim, const fmb_alloc *hook, fmb_system **out)
{
    if (dim < 0 || dim > FMB_DIM_MAX || !out)
        return FMB_ERR_ARG;
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_system *s;
    FMB_TRY(FMB_GET_ZERO(&mem, s, 1));
    s->mem = mem;
    for (int j = 0; j < dim; j++) {
        fmb_status st = add_default_name(s);
        if (st != FMB_OK) {
            fmb_system_free(s);
            return st;
        }
    }
    *out = s;
    return FMB_OK;
}

void fmb_system_free_row(fmb_system *s, fmb_sysrow *r)
{
    fmb_vec_clear(&r->val, r->nnz + 2, &s->mem);
    fmb_mem_put(&s->mem, r->val.s, r->nnz + 2, sizeof *r->val.s);
    fmb_mem_put(&s->mem, r->var, r->nnz, sizeof *r->var);
    fmb_mem_put_text(&s->mem, r->label);
}

void fmb_system_free(fmb_system *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < s->rows; i++)
        fmb_system_free_row(s, &s->row[i]);
    fmb_system_drop_objective(s);
    fmb_mem_put(&s->mem, s->row, s->row_capacity, sizeof *s->row);
    fmb_mem_put(&s->mem, s->mark, s->mark_capacity, sizeof *s->mark);
    fmb_names_clear(&s->names, &s->mem);
    fmb_mem mem = s->mem;
    fmb_mem_put(&mem, s, 1, sizeof *s);
}

/* ---- variables ------------------------------------------------------------------------------- */

int fmb_system_dim(const fmb_system *s)
{
    return s ? (int)s->names.size : 0;
}

static bool has_variable(const fmb_system *s, int j)
{
    return j >= 0 && j < fmb_system_dim(s);
}

static fmb_status add_name(fmb_system *s, const char *name)
{
    size_t n = s->names.size;
    if (n >= FMB_DIM_MAX)
        return fmb_system_refuse(s, "more than %d variables", FMB_DIM_MAX);
    FMB_TRY(FMB_RESERVE(&s->mem, &s->mark, &s->mark_capacity, n + 1));
    FMB_TRY(fmb_names_add(&s->names, name, &s->mem));
    s->mark[n] = (fmb_variable_mark){0};
    return FMB_OK;
}

/* Write "x<number>", faster than printf, as short queries need many names; returns its length. */
static int write_default_name(char *name, size_t number)
{
    int digits = 1;
    for (size_t k = number; k >= 10; k /= 10)
        digits++;
    name[0] = 'x';
    name[digits + 1] = '\0';
    for (int k = digits; k > 0; k--, number /= 10)
        name[k] = (char)('0' + number % 10);
    return digits + 1;
}

/* Add a variable of that name, with underscores appended while the name is taken. */
static fmb_status add_default_name(fmb_system *s)
{
    char name[64];
    int n = write_default_name(name, s->names.size + 1);
    while (fmb_names_find(&s->names, name) >= 0 && n < (int)sizeof name - 1) {
        name[n++] = '_';
        name[n] = '\0';
    }
    return add_name(s, name);
}

/* Is the name allowed for variable j (-1: a new one)? */
static fmb_status check_name(fmb_system *s, int j, const char *name)
{
    if (!name || !*name)
        return fmb_system_refuse(s, "a name that is %s", name ? "empty" : "NULL");
    int taken = fmb_names_find(&s->names, name);
    return taken < 0 || taken == j ? FMB_OK
                                   : fmb_system_refuse(s, "the name \"%.80s\" is taken", name);
}

fmb_status fmb_system_add_variable(fmb_system *s, const char *name, int *index)
{
    if (!s)
        return FMB_ERR_ARG;
    FMB_TRY(name ? check_name(s, -1, name) : FMB_OK);
    FMB_TRY(name ? add_name(s, name) : add_default_name(s));
    if (index)
        *index = fmb_system_dim(s) - 1;
    return FMB_OK;
}

const char *fmb_system_name(const fmb_system *s, int j)
{
    return has_variable(s, j) ? s->names.name[j] : NULL;
}

fmb_status fmb_system_set_name(fmb_system *s, int j, const char *name)
{
    if (!has_variable(s, j))
        return refuse_variable(s, j);
    FMB_TRY(check_name(s, j, name));
    if (strcmp(name, s->names.name[j]) == 0)
        return FMB_OK;
    return fmb_names_change(&s->names, j, name, &s->mem);
}

int fmb_system_find(const fmb_system *s, const char *name)
{
    return s && name ? fmb_names_find(&s->names, name) : -1;
}

bool fmb_system_asks_projection(const fmb_system *s)
{
    return s && s->asks_projection;
}

bool fmb_system_is_kept(const fmb_system *s, int j)
{
    return has_variable(s, j) && s->mark[j].kept;
}

void fmb_system_set_kept(fmb_system *s, int j, bool kept)
{
    if (!has_variable(s, j)) {
        (void)refuse_variable(s, j);
        return;
    }
    s->asks_projection = true;
    s->mark[j].kept = kept;
}

fmb_status fmb_system_set_integer(fmb_system *s, int j, bool integer)
{
    if (!has_variable(s, j))
        return refuse_variable(s, j);
    s->mark[j].integer = integer;
    return FMB_OK;
}

bool fmb_system_is_integer(const fmb_system *s, int j)
{
    return has_variable(s, j) && s->mark[j].integer;
}

int fmb_system_first_integer(const fmb_system *s)
{
    int j = 0;
    while (j < fmb_system_dim(s) && !s->mark[j].integer)
        j++;
    return j < fmb_system_dim(s) ? j : -1;
}

/* ---- rows ------------------------------------------------------------------------------------ */

size_t fmb_system_rows(const fmb_system *s)
{
    return s ? s->rows : 0;
}

fmb_rel fmb_system_rel(const fmb_system *s, size_t i)
{
    return i < fmb_system_rows(s) ? s->row[i].rel : FMB_LE;
}

const char *fmb_system_label(const fmb_system *s, size_t i)
{
    return i < fmb_system_rows(s) ? s->row[i].label : NULL;
}

fmb_status fmb_system_set_label(fmb_system *s, size_t i, const char *label)
{
    char *copy = NULL;
    if (i >= fmb_system_rows(s))
        return refuse_row(s, i);
    if (label && !(copy = fmb_mem_text(&s->mem, label)))
        return fmb_mem_status(&s->mem);
    fmb_mem_put_text(&s->mem, s->row[i].label);
    s->row[i].label = copy;
    return FMB_OK;
}

/* Memory for a row of n terms, not yet counted in s->rows, whose variables the caller writes. */
static fmb_status open_row(fmb_system *s, size_t n, fmb_rel rel, fmb_sysrow **out)
{
    FMB_TRY(FMB_RESERVE(&s->mem, &s->row, &s->row_capacity, s->rows + 1));
    fmb_sysrow *r = &s->row[s->rows];
    *r = (fmb_sysrow){.nnz = n, .rel = rel};
    r->var = fmb_mem_get(&s->mem, n, sizeof *r->var);
    r->val.s = fmb_mem_get(&s->mem, n + 2, sizeof *r->val.s);
    if (!r->var || !r->val.s) {
        fmb_status why = fmb_mem_status(&s->mem);
        fmb_system_free_row(s, r);
        return why;
    }
    *out = r;
    return FMB_OK;
}

/* The same with the variables copied. */
static fmb_status open_row_of(fmb_system *s, size_t n, const int *var, fmb_rel rel,
                              fmb_sysrow **out)
{
    FMB_TRY(open_row(s, n, rel, out));
    if (n > 0)
        memcpy((*out)->var, var, n * sizeof *var);
    return FMB_OK;
}

fmb_status fmb_system_append(fmb_system *s, size_t n, const int *var, mpz_t *z, fmb_rel rel)
{
    fmb_sysrow *r = NULL;
    FMB_TRY(open_row_of(s, n, var, rel, &r));
    fmb_status st = fmb_vec_set_z(&r->val, n + 2, z, &s->mem);
    if (st != FMB_OK)
        fmb_system_free_row(s, r);
    s->rows += st == FMB_OK;
    return st;
}

/* Copy the nonzero entries and the right side of dense[n + 1], then the denominator. */
static fmb_status copy_wide_entries(fmb_system *s, fmb_sysrow *r, size_t n, const fmb_vec *dense)
{
    size_t terms = 0;
    mpz_t *z = fmb_vec_block(r->nnz + 2, &s->mem);
    if (!z)
        return fmb_mem_status(&s->mem);
    for (size_t j = 0; j <= n; j++)
        if (j == n || fmb_vec_sgn(dense, j) != 0)
            fmb_vec_get(dense, j, z[terms++]);
    mpz_set_ui(z[terms], 1);
    fmb_status st = fmb_vec_set_z(&r->val, r->nnz + 2, z, &s->mem);
    fmb_vec_block_free(z, r->nnz + 2, &s->mem);
    return st;
}

static void copy_small_entries(fmb_sysrow *r, size_t n, const fmb_vec *dense)
{
    size_t terms = 0;
    for (size_t j = 0; j <= n; j++)
        if (j == n || dense->s[j] != 0)
            r->val.s[terms++] = dense->s[j];
    r->val.s[terms] = 1;
    fmb_vec_measure(&r->val, r->nnz + 2);
}

fmb_status fmb_system_append_dense(fmb_system *s, size_t n, const int *var, const int *place,
                                   const fmb_vec *row, fmb_rel rel)
{
    fmb_sysrow *r = NULL;
    fmb_status st = FMB_OK;
    size_t terms = 0;
    for (size_t j = 0; j < n; j++)
        terms += fmb_vec_sgn(row, j) != 0;
    FMB_TRY(open_row(s, terms, rel, &r));
    terms = 0;
    for (size_t j = 0; j < n; j++)
        if (fmb_vec_sgn(row, j) != 0)
            r->var[terms++] = var ? place[var[j]] : (int)j;
    if (row->z)
        st = copy_wide_entries(s, r, n, row);
    else
        copy_small_entries(r, n, row);
    if (st != FMB_OK)
        fmb_system_free_row(s, r);
    s->rows += st == FMB_OK;
    return st;
}

fmb_status fmb_system_append_small(fmb_system *s, size_t n, const int *var, const int64_t *z,
                                   fmb_rel rel)
{
    fmb_sysrow *r = NULL;
    FMB_TRY(open_row_of(s, n, var, rel, &r));
    memcpy(r->val.s, z, (n + 2) * sizeof *z);
    fmb_vec_measure(&r->val, n + 2);
    s->rows++;
    return FMB_OK;
}

void fmb_system_remove(fmb_system *s, size_t i)
{
    fmb_system_free_row(s, &s->row[i]);
    s->rows--;
    memmove(&s->row[i], &s->row[i + 1], (s->rows - i) * sizeof *s->row);
}

void fmb_system_drop_objective(fmb_system *s)
{
    if (s->sense != FMB_SENSE_NONE)
        fmb_system_free_row(s, &s->objective);
    s->sense = FMB_SENSE_NONE;
}

fmb_status fmb_system_copy_row(fmb_system *to, const fmb_sysrow *from)
{
    fmb_sysrow *r = NULL;
    FMB_TRY(open_row_of(to, from->nnz, from->var, from->rel, &r));
    r->turned = from->turned;
    fmb_status st = fmb_vec_copy(&r->val, &from->val, from->nnz + 2, &to->mem);
    if (st == FMB_OK && from->label && !(r->label = fmb_mem_text(&to->mem, from->label)))
        st = fmb_mem_status(&to->mem);
    if (st != FMB_OK)
        fmb_system_free_row(to, r);
    else
        to->rows++;
    return st;
}

/* Copy variables, names and marks of s to the empty t. */
static fmb_status copy_variables(fmb_system *t, const fmb_system *s)
{
    for (int j = 0; j < fmb_system_dim(s); j++) {
        FMB_TRY(add_name(t, fmb_system_name(s, j)));
        t->mark[j] = s->mark[j];
    }
    t->asks_projection = s->asks_projection;
    return FMB_OK;
}

/* Copy the objective of s to t, which has no rows yet. */
static fmb_status copy_objective(fmb_system *t, const fmb_system *s)
{
    if (s->sense == FMB_SENSE_NONE)
        return FMB_OK;
    FMB_TRY(fmb_system_copy_row(t, &s->objective));
    t->objective = t->row[--t->rows];
    t->sense = s->sense;
    return FMB_OK;
}

fmb_status fmb_system_copy_to(const fmb_system *s, const fmb_alloc *hook, fmb_system **out)
{
    fmb_system *t;
    FMB_TRY(fmb_system_new(0, hook, &t));
    fmb_status st = copy_variables(t, s);
    FMB_THEN(st, copy_objective(t, s));
    for (size_t i = 0; st == FMB_OK && i < s->rows; i++)
        st = fmb_system_copy_row(t, &s->row[i]);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    return st;
}

fmb_status fmb_system_copy(const fmb_system *s, fmb_system **out)
{
    return s && out ? fmb_system_copy_to(s, &s->mem.alloc, out) : FMB_ERR_ARG;
}
