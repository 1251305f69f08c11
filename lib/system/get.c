/* get.c: rows and the objective of a system as doubles, machine integers, text and rationals. */
#include "num/rationals.h"
#include "system/system_private.h"

/* ---- one number ------------------------------------------------------------------------------ */

void fmb_sysrow_expand(const fmb_sysrow *r, size_t n, mpz_t *z)
{
    for (size_t j = 0; j < n; j++)
        mpz_set_ui(z[j], 0);
    for (size_t k = 0; k <= r->nnz; k++)
        fmb_vec_get(&r->val, k, z[k < r->nnz ? (size_t)r->var[k] : n]);
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

static bool is_row_of_integers(const fmb_sysrow *r)
{
    return !fmb_vec_is_wide(&r->val) && r->val.s[r->nnz + 1] == 1;
}

/* The double nearest to entry k. */
static double entry_as_double(const fmb_sysrow *r, size_t k)
{
    double x;
    if (!fmb_vec_is_wide(&r->val) && fmb_nearest_quotient(r->val.s[k], r->val.s[r->nnz + 1], &x))
        return x;
    mpq_t q;
    mpq_init(q);
    fmb_sysrow_get_q(r, k, q);
    x = fmb_nearest_double(q);
    mpq_clear(q);
    return x;
}

/* Entry k, if it is an integer that fits into int64. */
static bool entry_as_integer(const fmb_sysrow *r, size_t k, int64_t *out)
{
    if (is_row_of_integers(r)) {
        *out = r->val.s[k];
        return true;
    }
    mpq_t q;
    mpq_init(q);
    fmb_sysrow_get_q(r, k, q);
    bool fits = fmb_rational_as_integer(q, out);
    mpq_clear(q);
    return fits;
}

static size_t entry_as_text(const fmb_sysrow *r, size_t k, char *text, size_t size)
{
    mpq_t q;
    mpq_init(q);
    fmb_sysrow_get_q(r, k, q);
    size_t length = fmb_rational_print(q, text, size);
    mpq_clear(q);
    return length;
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* Row i, or NULL. */
static const fmb_sysrow *row_or_null(const fmb_system *s, size_t i)
{
    return i < fmb_system_rows(s) ? &s->row[i] : NULL;
}

size_t fmb_system_terms(const fmb_system *s, size_t i)
{
    const fmb_sysrow *r = row_or_null(s, i);
    return r ? r->nnz : 0;
}

size_t fmb_system_nonzeros(const fmb_system *s)
{
    size_t n = 0;
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        n += s->row[i].nnz;
    return n;
}

static bool has_rows(const fmb_system *s, size_t first, size_t n)
{
    return s && first <= s->rows && n <= s->rows - first;
}

/* The starts of rows, the variables of terms, and the relations. */
static void get_shape(const fmb_system *s, size_t first, size_t n, size_t *start, int *var,
                      fmb_rel *rel)
{
    size_t at = 0;
    for (size_t i = 0; i < n; i++) {
        const fmb_sysrow *r = &s->row[first + i];
        if (start)
            start[i] = at;
        if (rel)
            rel[i] = r->rel;
        for (size_t k = 0; var && k < r->nnz; k++)
            var[at + k] = r->var[k];
        at += r->nnz;
    }
    if (start)
        start[n] = at;
}

fmb_status fmb_system_get_rows(const fmb_system *s, size_t first, size_t n, size_t *start, int *var,
                               double *coef, fmb_rel *rel, double *b)
{
    if (!has_rows(s, first, n))
        return FMB_ERR_ARG;
    for (size_t i = 0, at = 0; i < n; i++) {
        const fmb_sysrow *r = &s->row[first + i];
        for (size_t k = 0; coef && k < r->nnz; k++)
            coef[at++] = entry_as_double(r, k);
        if (b)
            b[i] = entry_as_double(r, r->nnz);
    }
    get_shape(s, first, n, start, var, rel);
    return FMB_OK;
}

/* Do the numbers wanted fit? */
static bool row_fits(const fmb_sysrow *r, bool coef, bool b)
{
    int64_t z;
    bool fits = true;
    for (size_t k = 0; coef && fits && k < r->nnz; k++)
        fits = entry_as_integer(r, k, &z);
    return fits && (!b || entry_as_integer(r, r->nnz, &z));
}

fmb_status fmb_system_get_rows_int(const fmb_system *s, size_t first, size_t n, size_t *start,
                                   int *var, int64_t *coef, fmb_rel *rel, int64_t *b)
{
    if (!has_rows(s, first, n))
        return FMB_ERR_ARG;
    for (size_t i = 0; i < n; i++)
        if (!row_fits(&s->row[first + i], coef, b))
            return FMB_ERR_RANGE;
    for (size_t i = 0, at = 0; i < n; i++) {
        const fmb_sysrow *r = &s->row[first + i];
        for (size_t k = 0; coef && k < r->nnz; k++)
            (void)entry_as_integer(r, k, &coef[at++]);
        if (b)
            (void)entry_as_integer(r, r->nnz, &b[i]);
    }
    get_shape(s, first, n, start, var, rel);
    return FMB_OK;
}

static const fmb_sysrow *row_of_term(const fmb_system *s, size_t i, size_t k)
{
    return k < fmb_system_terms(s, i) ? &s->row[i] : NULL;
}

size_t fmb_system_term_text(const fmb_system *s, size_t i, size_t k, char *text, size_t size)
{
    return entry_as_text(row_of_term(s, i, k), k, text, size);
}

int fmb_system_term_q(const fmb_system *s, size_t i, size_t k, mpq_t coef)
{
    const fmb_sysrow *r = row_of_term(s, i, k);
    fmb_sysrow_get_q(r, k, coef);
    return r ? r->var[k] : -1;
}

size_t fmb_system_rhs_text(const fmb_system *s, size_t i, char *text, size_t size)
{
    return entry_as_text(row_or_null(s, i), fmb_system_terms(s, i), text, size);
}

void fmb_system_rhs_q(const fmb_system *s, size_t i, mpq_t b)
{
    fmb_sysrow_get_q(row_or_null(s, i), fmb_system_terms(s, i), b);
}

/* ---- the objective --------------------------------------------------------------------------- */

/* The row of the objective; NULL: there is none. */
static const fmb_sysrow *objective_row(const fmb_system *s)
{
    return s && s->sense ? &s->objective : NULL;
}

size_t fmb_system_objective_terms(const fmb_system *s)
{
    const fmb_sysrow *r = objective_row(s);
    return r ? r->nnz : 0;
}

fmb_sense fmb_system_get_objective(const fmb_system *s, int *var, double *coef, double *constant)
{
    const fmb_sysrow *r = objective_row(s);
    if (!r)
        return FMB_SENSE_NONE;
    for (size_t k = 0; k < r->nnz; k++) {
        if (var)
            var[k] = r->var[k];
        if (coef)
            coef[k] = entry_as_double(r, k);
    }
    if (constant)
        *constant = entry_as_double(r, r->nnz);
    return s->sense;
}

fmb_status fmb_system_get_objective_int(const fmb_system *s, int *var, int64_t *coef,
                                        int64_t *constant)
{
    const fmb_sysrow *r = objective_row(s);
    if (!r)
        return s ? FMB_OK : FMB_ERR_ARG;
    if (!row_fits(r, coef, constant))
        return FMB_ERR_RANGE;
    for (size_t k = 0; k < r->nnz; k++) {
        if (var)
            var[k] = r->var[k];
        if (coef)
            (void)entry_as_integer(r, k, &coef[k]);
    }
    if (constant)
        (void)entry_as_integer(r, r->nnz, constant);
    return FMB_OK;
}

static const fmb_sysrow *objective_of_term(const fmb_system *s, size_t k)
{
    return k < fmb_system_objective_terms(s) ? &s->objective : NULL;
}

int fmb_system_objective_term_q(const fmb_system *s, size_t k, mpq_t coef)
{
    const fmb_sysrow *r = objective_of_term(s, k);
    fmb_sysrow_get_q(r, k, coef);
    return r ? r->var[k] : -1;
}

void fmb_system_objective_constant_q(const fmb_system *s, mpq_t constant)
{
    fmb_sysrow_get_q(objective_row(s), fmb_system_objective_terms(s), constant);
}

size_t fmb_system_objective_term_text(const fmb_system *s, size_t k, char *text, size_t size)
{
    return entry_as_text(objective_of_term(s, k), k, text, size);
}

size_t fmb_system_objective_constant_text(const fmb_system *s, char *text, size_t size)
{
    return entry_as_text(objective_row(s), fmb_system_objective_terms(s), text, size);
}
