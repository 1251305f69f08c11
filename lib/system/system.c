/* system.c: life of a system, its variables and labels; see system.h. */
#include "system/system.h"

#include <stdio.h>
#include <string.h>

static fmb_status add_default_name(fmb_system *s);

fmb_status fmb_system_new(int dim, const fmb_alloc *hook, fmb_system **out)
{
    if (dim < 0 || !out)
        return FMB_ERR_ARG;
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_system *s = fmb_mem_zero(&mem, 1, sizeof *s);
    if (!s)
        return FMB_ERR_MEMORY;
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

static void free_row(fmb_system *s, fmb_sysrow *r)
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
        free_row(s, &s->row[i]);
    fmb_mem_put(&s->mem, s->row, s->row_capacity, sizeof *s->row);
    fmb_mem_put(&s->mem, s->kept, s->kept_capacity, sizeof *s->kept);
    fmb_names_clear(&s->names, &s->mem);
    fmb_mem mem = s->mem;
    fmb_mem_put(&mem, s, 1, sizeof *s);
}

/* ---- variables ------------------------------------------------------------------------------- */

int fmb_system_dim(const fmb_system *s)
{
    return (int)s->names.size;
}

static fmb_status add_name(fmb_system *s, const char *name)
{
    size_t n = s->names.size;
    if (n >= INT32_MAX / 2)
        return FMB_ERR_ARG;
    fmb_status st =
        fmb_mem_reserve(&s->mem, (void **)&s->kept, &s->kept_capacity, n + 1, sizeof *s->kept);
    if (st == FMB_OK)
        st = fmb_names_add(&s->names, name, &s->mem);
    if (st == FMB_OK)
        s->kept[n] = false;
    return st;
}

/* "x<j+1>", with underscores behind it while that name is taken. */
static fmb_status add_default_name(fmb_system *s)
{
    char name[64];
    int n = snprintf(name, sizeof name, "x%zu", s->names.size + 1);
    while (fmb_names_find(&s->names, name) >= 0 && n < (int)sizeof name - 1) {
        name[n++] = '_';
        name[n] = '\0';
    }
    return add_name(s, name);
}

fmb_status fmb_system_add_variable(fmb_system *s, const char *name, int *index)
{
    if (name && (!*name || fmb_names_find(&s->names, name) >= 0))
        return FMB_ERR_ARG;
    fmb_status st = name ? add_name(s, name) : add_default_name(s);
    if (st == FMB_OK && index)
        *index = fmb_system_dim(s) - 1;
    return st;
}

const char *fmb_system_name(const fmb_system *s, int j)
{
    return s->names.name[j];
}

fmb_status fmb_system_set_name(fmb_system *s, int j, const char *name)
{
    if (j < 0 || j >= fmb_system_dim(s) || !name || !*name)
        return FMB_ERR_ARG;
    int taken = fmb_names_find(&s->names, name);
    if (taken >= 0)
        return taken == j ? FMB_OK : FMB_ERR_ARG;
    return fmb_names_change(&s->names, j, name, &s->mem);
}

int fmb_system_find(const fmb_system *s, const char *name)
{
    return fmb_names_find(&s->names, name);
}

bool fmb_system_asks_projection(const fmb_system *s)
{
    return s->asks_projection;
}

bool fmb_system_is_kept(const fmb_system *s, int j)
{
    return s->kept[j];
}

void fmb_system_set_kept(fmb_system *s, int j, bool kept)
{
    s->asks_projection = true;
    s->kept[j] = kept;
}

/* ---- rows ------------------------------------------------------------------------------------ */

size_t fmb_system_rows(const fmb_system *s)
{
    return s->rows;
}

fmb_rel fmb_system_rel(const fmb_system *s, size_t i)
{
    return s->row[i].rel;
}

const char *fmb_system_label(const fmb_system *s, size_t i)
{
    return s->row[i].label;
}

fmb_status fmb_system_set_label(fmb_system *s, size_t i, const char *label)
{
    char *copy = NULL;
    if (i >= s->rows)
        return FMB_ERR_ARG;
    if (label && !(copy = fmb_mem_text(&s->mem, label)))
        return FMB_ERR_MEMORY;
    fmb_mem_put_text(&s->mem, s->row[i].label);
    s->row[i].label = copy;
    return FMB_OK;
}

/* Room for a row of n terms, not yet counted in s->rows. */
static fmb_status open_row(fmb_system *s, size_t n, fmb_sysrow **out)
{
    fmb_status st =
        fmb_mem_reserve(&s->mem, (void **)&s->row, &s->row_capacity, s->rows + 1, sizeof *s->row);
    if (st != FMB_OK)
        return st;
    fmb_sysrow *r = &s->row[s->rows];
    *r = (fmb_sysrow){.nnz = n};
    r->var = fmb_mem_get(&s->mem, n, sizeof *r->var);
    r->val.s = fmb_mem_get(&s->mem, n + 2, sizeof *r->val.s);
    if (!r->var || !r->val.s) {
        free_row(s, r);
        return FMB_ERR_MEMORY;
    }
    *out = r;
    return FMB_OK;
}

fmb_status fmb_system_append(fmb_system *s, size_t n, const int *var, mpz_t *z, fmb_rel rel)
{
    fmb_sysrow *r;
    fmb_status st = open_row(s, n, &r);
    if (st != FMB_OK)
        return st;
    st = fmb_vec_set_z(&r->val, n + 2, z, &s->mem);
    if (st != FMB_OK) {
        free_row(s, r);
        return st;
    }
    if (n > 0)
        memcpy(r->var, var, n * sizeof *var);
    r->rel = rel;
    s->rows++;
    return FMB_OK;
}

void fmb_system_remove(fmb_system *s, size_t i)
{
    free_row(s, &s->row[i]);
    s->rows--;
    memmove(&s->row[i], &s->row[i + 1], (s->rows - i) * sizeof *s->row);
}

static fmb_status copy_row(fmb_system *to, const fmb_sysrow *from)
{
    fmb_sysrow *r;
    fmb_status st = open_row(to, from->nnz, &r);
    if (st != FMB_OK)
        return st;
    if (from->nnz > 0)
        memcpy(r->var, from->var, from->nnz * sizeof *r->var);
    r->rel = from->rel;
    st = fmb_vec_copy(&r->val, &from->val, from->nnz + 2, &to->mem);
    if (st == FMB_OK && from->label && !(r->label = fmb_mem_text(&to->mem, from->label)))
        st = FMB_ERR_MEMORY;
    if (st != FMB_OK)
        free_row(to, r);
    else
        to->rows++;
    return st;
}

/* Variables, names and marks of s onto the empty t. */
static fmb_status copy_variables(fmb_system *t, const fmb_system *s)
{
    for (int j = 0; j < fmb_system_dim(s); j++) {
        fmb_status st = add_name(t, fmb_system_name(s, j));
        if (st != FMB_OK)
            return st;
        t->kept[j] = s->kept[j];
    }
    t->asks_projection = s->asks_projection;
    return FMB_OK;
}

fmb_status fmb_system_copy(const fmb_system *s, fmb_system **out)
{
    fmb_system *t;
    fmb_status st = fmb_system_new(0, &s->mem.alloc, &t);
    if (st != FMB_OK)
        return st;
    st = copy_variables(t, s);
    for (size_t i = 0; st == FMB_OK && i < s->rows; i++)
        st = copy_row(t, &s->row[i]);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    return st;
}
