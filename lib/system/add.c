/* add.c: rows from doubles, machine integers and rationals; and back to rationals. */
#include <math.h>
#include <stdlib.h>

#include "system/system.h"

/* Rationals of one row on their way in: terms, then the right side. */
typedef struct draft {
    int *var;
    mpq_t *q; /* [capacity + 1] */
    size_t n, capacity;
} draft;

static fmb_status draft_init(draft *d, size_t capacity, fmb_mem *mem)
{
    *d = (draft){.capacity = capacity};
    d->var = fmb_mem_get(mem, capacity, sizeof *d->var);
    d->q = fmb_mem_get(mem, capacity + 1, sizeof *d->q);
    if (!d->var || !d->q) {
        fmb_mem_put(mem, d->var, capacity, sizeof *d->var);
        fmb_mem_put(mem, d->q, capacity + 1, sizeof *d->q);
        return fmb_mem_status(mem);
    }
    for (size_t i = 0; i <= capacity; i++)
        mpq_init(d->q[i]);
    return FMB_OK;
}

static void draft_clear(draft *d, fmb_mem *mem)
{
    for (size_t i = 0; i <= d->capacity; i++)
        mpq_clear(d->q[i]);
    fmb_mem_put(mem, d->var, d->capacity, sizeof *d->var);
    fmb_mem_put(mem, d->q, d->capacity + 1, sizeof *d->q);
}

/* Bring the n terms and the right side q[n] over their common denominator and append them. */
static fmb_status draft_append(const draft *d, fmb_system *s, fmb_rel rel)
{
    mpz_t *z = fmb_mem_get(&s->mem, d->n + 2, sizeof *z);
    if (!z)
        return FMB_ERR_MEMORY;
    for (size_t i = 0; i < d->n + 2; i++)
        mpz_init(z[i]);
    mpz_ptr den = z[d->n + 1];
    mpz_set_ui(den, 1);
    for (size_t i = 0; i <= d->n; i++)
        mpz_lcm(den, den, mpq_denref(d->q[i]));
    for (size_t i = 0; i <= d->n; i++) {
        mpz_divexact(z[i], den, mpq_denref(d->q[i]));
        mpz_mul(z[i], z[i], mpq_numref(d->q[i]));
    }
    fmb_status st = fmb_system_append(s, d->n, d->var, z, rel);
    for (size_t i = 0; i < d->n + 2; i++)
        mpz_clear(z[i]);
    fmb_mem_put(&s->mem, z, d->n + 2, sizeof *z);
    return st;
}

static bool is_rel(fmb_rel rel)
{
    return rel == FMB_LE || rel == FMB_LT || rel == FMB_EQ;
}

/* q = the j-th number of an array. */
typedef void setter(mpq_t q, const void *numbers, size_t j);

static void set_double(mpq_t q, const void *numbers, size_t j)
{
    mpq_set_d(q, ((const double *)numbers)[j]);
}

static void set_int(mpq_t q, const void *numbers, size_t j)
{
    mpq_set_si(q, ((const int64_t *)numbers)[j], 1);
}

/* Append a.x REL *b; a has length dim. */
static fmb_status add_dense(fmb_system *s, setter *set, const void *a, fmb_rel rel, const void *b)
{
    draft d;
    fmb_status st = draft_init(&d, s->names.size, &s->mem);
    if (st != FMB_OK)
        return st;
    for (size_t j = 0; j < d.capacity; j++) {
        set(d.q[d.n], a, j);
        d.var[d.n] = (int)j;
        d.n += mpq_sgn(d.q[d.n]) != 0;
    }
    set(d.q[d.n], b, 0);
    st = draft_append(&d, s, rel);
    draft_clear(&d, &s->mem);
    return st;
}

fmb_status fmb_system_add(fmb_system *s, const double *a, fmb_rel rel, double b)
{
    bool good = is_rel(rel) && isfinite(b);
    for (size_t j = 0; j < s->names.size; j++)
        good = good && isfinite(a[j]);
    return good ? add_dense(s, set_double, a, rel, &b) : FMB_ERR_ARG;
}

fmb_status fmb_system_add_int(fmb_system *s, const int64_t *a, fmb_rel rel, int64_t b)
{
    return is_rel(rel) ? add_dense(s, set_int, a, rel, &b) : FMB_ERR_ARG;
}

typedef struct place {
    int var;
    size_t at;
} place;

static int by_var(const void *x, const void *y)
{
    const place *a = x, *b = y;
    return a->var != b->var ? (a->var > b->var) - (a->var < b->var)
                            : (a->at > b->at) - (a->at < b->at);
}

/* Terms sorted by variable, equal variables added up, zeros dropped. */
static fmb_status draft_gather(draft *d, size_t n, const int *var, mpq_t *coef, fmb_mem *mem)
{
    place *order = fmb_mem_get(mem, n, sizeof *order);
    if (!order)
        return fmb_mem_status(mem);
    for (size_t k = 0; k < n; k++)
        order[k] = (place){var[k], k};
    qsort(order, n, sizeof *order, by_var);
    for (size_t k = 0; k < n;) {
        int v = order[k].var;
        mpq_set_ui(d->q[d->n], 0, 1);
        for (; k < n && order[k].var == v; k++)
            mpq_add(d->q[d->n], d->q[d->n], coef[order[k].at]);
        d->var[d->n] = v;
        d->n += mpq_sgn(d->q[d->n]) != 0;
    }
    fmb_mem_put(mem, order, n, sizeof *order);
    return FMB_OK;
}

fmb_status fmb_system_add_q(fmb_system *s, size_t n, const int *var, mpq_t *coef, fmb_rel rel,
                            const mpq_t b)
{
    if (!is_rel(rel))
        return FMB_ERR_ARG;
    for (size_t k = 0; k < n; k++)
        if (var[k] < 0 || var[k] >= fmb_system_dim(s))
            return FMB_ERR_ARG;
    draft d;
    fmb_status st = draft_init(&d, n, &s->mem);
    if (st != FMB_OK)
        return st;
    st = draft_gather(&d, n, var, coef, &s->mem);
    if (st == FMB_OK) {
        mpq_set(d.q[d.n], b);
        st = draft_append(&d, s, rel);
    }
    draft_clear(&d, &s->mem);
    return st;
}

/* ---- and back -------------------------------------------------------------------------------- */

size_t fmb_system_terms(const fmb_system *s, size_t i)
{
    return s->row[i].nnz;
}

static void get_q(const fmb_sysrow *r, size_t k, mpq_t out)
{
    fmb_vec_get(&r->val, k, mpq_numref(out));
    fmb_vec_get(&r->val, r->nnz + 1, mpq_denref(out));
    mpq_canonicalize(out);
}

int fmb_system_term_q(const fmb_system *s, size_t i, size_t k, mpq_t coef)
{
    get_q(&s->row[i], k, coef);
    return s->row[i].var[k];
}

void fmb_system_rhs_q(const fmb_system *s, size_t i, mpq_t b)
{
    get_q(&s->row[i], s->row[i].nnz, b);
}
