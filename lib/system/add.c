/* add.c: rows from doubles, machine integers and rationals; and back to rationals. */
#include <math.h>
#include <stdlib.h>

#include "system/system_private.h"

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

/* Bring the n terms and the right side q[n] over their common denominator and append them, with the
 * other sign if they are to be greater. */
static fmb_status draft_append(const draft *d, fmb_system *s, fmb_rel rel)
{
    mpz_t *z = fmb_mem_get(&s->mem, d->n + 2, sizeof *z);
    if (!z)
        return fmb_mem_status(&s->mem);
    for (size_t i = 0; i < d->n + 2; i++)
        mpz_init(z[i]);
    mpz_ptr den = z[d->n + 1];
    mpz_set_ui(den, 1);
    for (size_t i = 0; i <= d->n; i++)
        mpz_lcm(den, den, mpq_denref(d->q[i]));
    for (size_t i = 0; i <= d->n; i++) {
        mpz_divexact(z[i], den, mpq_denref(d->q[i]));
        mpz_mul(z[i], z[i], mpq_numref(d->q[i]));
        if (rel == FMB_GE || rel == FMB_GT)
            mpz_neg(z[i], z[i]);
    }
    rel = rel == FMB_GE ? FMB_LE : rel == FMB_GT ? FMB_LT : rel;
    fmb_status st = fmb_system_append(s, d->n, d->var, z, rel);
    for (size_t i = 0; i < d->n + 2; i++)
        mpz_clear(z[i]);
    fmb_mem_put(&s->mem, z, d->n + 2, sizeof *z);
    return st;
}

static fmb_status check_relation(fmb_system *s, fmb_rel rel)
{
    return (unsigned)rel <= FMB_GT ? FMB_OK : fmb_system_refuse(s, "relation %d is none", (int)rel);
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

/* What fmb_system_add and fmb_system_add_int may not be given. */
static fmb_status check_dense(fmb_system *s, const void *a, fmb_rel rel)
{
    if (!s || (!a && s->names.size > 0))
        return fmb_system_refuse(s, "coefficients that are NULL");
    return check_relation(s, rel);
}

fmb_status fmb_system_add(fmb_system *s, const double *a, fmb_rel rel, double b)
{
    fmb_status st = check_dense(s, a, rel);
    for (size_t j = 0; st == FMB_OK && j < s->names.size; j++)
        if (!isfinite(a[j]))
            st = fmb_system_refuse(s, "coefficient of %.80s is %g", s->names.name[j], a[j]);
    if (st == FMB_OK && !isfinite(b))
        st = fmb_system_refuse(s, "right side is %g", b);
    return st == FMB_OK ? add_dense(s, set_double, a, rel, &b) : st;
}

fmb_status fmb_system_add_int(fmb_system *s, const int64_t *a, fmb_rel rel, int64_t b)
{
    fmb_status st = check_dense(s, a, rel);
    return st == FMB_OK ? add_dense(s, set_int, a, rel, &b) : st;
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

/* to += from. GMP needs lowest terms over a positive denominator even to copy; the caller may have
 * written otherwise. */
static void add_rational(mpq_t to, mpq_srcptr from, mpq_t scratch)
{
    mpz_set(mpq_numref(scratch), mpq_numref(from));
    mpz_set(mpq_denref(scratch), mpq_denref(from));
    mpq_canonicalize(scratch);
    mpq_add(to, to, scratch);
}

/* Terms sorted by variable, equal variables added up, zeros dropped; then the right side. */
static fmb_status draft_gather(draft *d, size_t n, const int *var, mpq_t *coef, mpq_srcptr b,
                               fmb_mem *mem)
{
    mpq_t scratch;
    place *order = fmb_mem_get(mem, n, sizeof *order);
    if (!order)
        return fmb_mem_status(mem);
    for (size_t k = 0; k < n; k++)
        order[k] = (place){var[k], k};
    qsort(order, n, sizeof *order, by_var);
    mpq_init(scratch);
    for (size_t k = 0; k < n;) {
        int v = order[k].var;
        mpq_set_ui(d->q[d->n], 0, 1);
        for (; k < n && order[k].var == v; k++)
            add_rational(d->q[d->n], coef[order[k].at], scratch);
        d->var[d->n] = v;
        d->n += mpq_sgn(d->q[d->n]) != 0;
    }
    add_rational(d->q[d->n], b, scratch);
    mpq_clear(scratch);
    fmb_mem_put(mem, order, n, sizeof *order);
    return FMB_OK;
}

static bool is_rational(mpq_srcptr q)
{
    return mpz_sgn(mpq_denref(q)) != 0;
}

/* What fmb_system_add_q may not be given. */
static fmb_status check_terms(fmb_system *s, size_t n, const int *var, mpq_t *coef, mpq_srcptr b)
{
    if (!s || !b || (n > 0 && (!var || !coef)))
        return fmb_system_refuse(s, "%s NULL",
                                 b ? "variables or coefficients are" : "right side is");
    for (size_t k = 0; k < n; k++)
        if (var[k] < 0 || var[k] >= fmb_system_dim(s))
            return fmb_system_refuse(s, "term %zu is of variable %d, and the system has %d", k,
                                     var[k], fmb_system_dim(s));
        else if (!is_rational(coef[k]))
            return fmb_system_refuse(s, "coefficient of %.80s has denominator 0",
                                     s->names.name[var[k]]);
    return is_rational(b) ? FMB_OK : fmb_system_refuse(s, "right side has denominator 0");
}

fmb_status fmb_system_add_q(fmb_system *s, size_t n, const int *var, mpq_t *coef, fmb_rel rel,
                            const mpq_t b)
{
    draft d;
    fmb_status st = check_terms(s, n, var, coef, b);
    if (st == FMB_OK)
        st = check_relation(s, rel);
    if (st == FMB_OK)
        st = draft_init(&d, n, &s->mem);
    if (st != FMB_OK)
        return st;
    st = draft_gather(&d, n, var, coef, b, &s->mem);
    if (st == FMB_OK)
        st = draft_append(&d, s, rel);
    draft_clear(&d, &s->mem);
    return st;
}

/* ---- and back -------------------------------------------------------------------------------- */

size_t fmb_system_terms(const fmb_system *s, size_t i)
{
    return i < fmb_system_rows(s) ? s->row[i].nnz : 0;
}

void fmb_sysrow_get_q(const fmb_sysrow *r, size_t k, mpq_t out)
{
    if (!out)
        return;
    mpq_set_ui(out, 0, 1);
    if (!r || k > r->nnz)
        return;
    fmb_vec_get(&r->val, k, mpq_numref(out));
    fmb_vec_get(&r->val, r->nnz + 1, mpq_denref(out));
    mpq_canonicalize(out);
}

int fmb_system_term_q(const fmb_system *s, size_t i, size_t k, mpq_t coef)
{
    bool there = k < fmb_system_terms(s, i);
    fmb_sysrow_get_q(there ? &s->row[i] : NULL, k, coef);
    return there ? s->row[i].var[k] : -1;
}

void fmb_system_rhs_q(const fmb_system *s, size_t i, mpq_t b)
{
    bool there = i < fmb_system_rows(s);
    fmb_sysrow_get_q(there ? &s->row[i] : NULL, there ? s->row[i].nnz : 0, b);
}
