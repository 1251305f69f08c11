/* add.c: rows from doubles, machine integers and rationals, one or many.
 *
 * Numbers of all kinds are read by the same functions. Rows whose variables increase and whose
 * numbers, over their common denominator, are small (num/vec.h) are written directly as words; the
 * others as rationals. Both methods give the same row.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "num/gcd.h"
#include "system/number_kind.h"
#include "system/system_private.h"

/* ---- data of the caller ---------------------------------------------------------------------- */

typedef struct matrix {
    const fmb_number_kind *kind;
    size_t rows;
    const size_t *start; /* [rows + 1] row i is terms start[i]..start[i + 1); NULL: dense */
    const int *var;      /* by term; NULL: dense */
    const void *coef, *right;
    const fmb_rel *rel; /* [rows], or NULL: <= */
    size_t dim;
} matrix;

/* Terms of row i are [first, end). */
static size_t first_term(const matrix *m, size_t i)
{
    return m->start ? m->start[i] : i * m->dim;
}

static int variable_of_term(const matrix *m, size_t i, size_t term)
{
    return m->var ? m->var[term] : (int)(term - first_term(m, i));
}

/* ---- refused arguments ----------------------------------------------------------------------- */

/* Refuse row i, whose number is reported only if there are several rows. */
__attribute__((format(printf, 4, 5))) static fmb_status
refuse_in_row(fmb_system *s, const matrix *m, size_t i, const char *format, ...)
{
    char what[160];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    return m->rows == 1 ? fmb_system_refuse(s, "%s", what)
                        : fmb_system_refuse(s, "row %zu: %s", i, what);
}

static fmb_status check_given_term(fmb_system *s, const matrix *m, size_t i, size_t term)
{
    char buf[FMB_WRONG_NUMBER];
    int j = variable_of_term(m, i, term);
    if (j < 0 || (size_t)j >= m->dim)
        return refuse_in_row(s, m, i, "term %zu is of variable %d, and the system has %zu",
                             term - first_term(m, i), j, m->dim);
    const char *wrong = m->kind->wrong(m->coef, term, buf);
    return wrong ? refuse_in_row(s, m, i, "coefficient of %.80s %s", s->names.name[j], wrong)
                 : FMB_OK;
}

static fmb_status check_given_row(fmb_system *s, const matrix *m, size_t i)
{
    char buf[FMB_WRONG_NUMBER];
    fmb_status st = FMB_OK;
    if (m->rel && (unsigned)m->rel[i] > FMB_GT)
        return refuse_in_row(s, m, i, "relation %d is none", (int)m->rel[i]);
    for (size_t k = first_term(m, i); st == FMB_OK && k < first_term(m, i + 1); k++)
        st = check_given_term(s, m, i, k);
    const char *wrong = st == FMB_OK ? m->kind->wrong(m->right, i, buf) : NULL;
    return wrong ? refuse_in_row(s, m, i, "right side %s", wrong) : st;
}

/* Check the starts of rows before any row is read. */
static fmb_status check_starts(fmb_system *s, const matrix *m)
{
    size_t all;
    if (!m->start)
        return __builtin_mul_overflow(m->rows, m->dim, &all)
                   ? fmb_system_refuse(s, "%zu rows of %zu numbers", m->rows, m->dim)
                   : FMB_OK;
    for (size_t i = 0; i < m->rows; i++)
        if (m->start[i + 1] < m->start[i])
            return refuse_in_row(s, m, i, "it begins at %zu and ends at %zu", m->start[i],
                                 m->start[i + 1]);
    return FMB_OK;
}

static fmb_status check_matrix(fmb_system *s, const matrix *m)
{
    if (!s)
        return FMB_ERR_ARG;
    if (!m->start && m->var)
        return fmb_system_refuse(s, "starts of rows are NULL");
    if (m->rows > 0 && !m->right)
        return fmb_system_refuse(s, "right side is NULL");
    fmb_status st = check_starts(s, m);
    bool any = st == FMB_OK && m->rows > 0 && first_term(m, m->rows) > first_term(m, 0);
    if (any && (!m->coef || (m->start && !m->var)))
        return fmb_system_refuse(s, "%s NULL", m->coef ? "variables are" : "coefficients are");
    for (size_t i = 0; st == FMB_OK && i < m->rows; i++)
        st = check_given_row(s, m, i);
    return st;
}

/* ---- small rows ------------------------------------------------------------------------------ */

/* Memory for the longest row. */
typedef struct row_words {
    int *var;
    int64_t *z; /* [most + 2] */
    size_t most;
} row_words;

/* Extend the least common denominator; false if it is not small. */
static bool include_denominator(uint64_t *all, uint64_t d)
{
    uint64_t most = (uint64_t)1 << FMB_SMALL_BITS;
    if (d == 1 || (d > 0 && *all % d == 0))
        return true;
    return d > 0 && !__builtin_mul_overflow(*all, d / fmb_gcd64(*all, d), all) && *all < most;
}

/* The least common denominator of row i; false if variables do not increase, or it is not small. */
static bool find_row_denominator(const matrix *m, size_t i, uint64_t *all)
{
    int last = -1;
    *all = 1;
    bool small = include_denominator(all, m->kind->denominator(m->right, i));
    for (size_t k = first_term(m, i); small && k < first_term(m, i + 1); k++) {
        int j = variable_of_term(m, i, k);
        small = j > last && include_denominator(all, m->kind->denominator(m->coef, k));
        last = j;
    }
    return small;
}

/* Row i as words, *n terms of it; false if it is not small. */
static bool take_small_row(const matrix *m, size_t i, row_words *w, size_t *n)
{
    uint64_t all;
    *n = 0;
    if (!find_row_denominator(m, i, &all))
        return false;
    for (size_t k = first_term(m, i); k < first_term(m, i + 1); k++) {
        if (m->kind->is_zero(m->coef, k))
            continue;
        if (!m->kind->times(m->coef, k, all, &w->z[*n]))
            return false;
        w->var[(*n)++] = variable_of_term(m, i, k);
    }
    w->z[*n + 1] = (int64_t)all;
    return m->kind->times(m->right, i, all, &w->z[*n]);
}

static bool is_greater(fmb_rel rel)
{
    return rel == FMB_GE || rel == FMB_GT;
}

/* The relation as it is stored. */
static fmb_rel turned(fmb_rel rel)
{
    return rel == FMB_GE ? FMB_LE : rel == FMB_GT ? FMB_LT : rel;
}

/* ---- other rows ------------------------------------------------------------------------------ */

/* Rationals of a row being added: terms, then the right side. */
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

/* Bring the n terms and the right side q[n] over their common denominator and append them, negated
 * if the relation is > or >=. */
static fmb_status draft_append(const draft *d, fmb_system *s, fmb_rel rel)
{
    mpz_t *z = fmb_vec_block(d->n + 2, &s->mem);
    if (!z)
        return fmb_mem_status(&s->mem);
    mpz_ptr den = z[d->n + 1];
    mpz_set_ui(den, 1);
    for (size_t i = 0; i <= d->n; i++)
        mpz_lcm(den, den, mpq_denref(d->q[i]));
    for (size_t i = 0; i <= d->n; i++) {
        mpz_divexact(z[i], den, mpq_denref(d->q[i]));
        mpz_mul(z[i], z[i], mpq_numref(d->q[i]));
        if (is_greater(rel))
            mpz_neg(z[i], z[i]);
    }
    fmb_status st = fmb_system_append(s, d->n, d->var, z, turned(rel));
    fmb_vec_block_free(z, d->n + 2, &s->mem);
    return st;
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

/* Terms of row i sorted by variable, equal variables added up, zeros dropped; then the right side.
 */
static fmb_status draft_gather(draft *d, const matrix *m, size_t i, fmb_mem *mem)
{
    mpq_t scratch;
    size_t first = first_term(m, i), n = first_term(m, i + 1) - first;
    place *order;
    FMB_TRY(FMB_GET(mem, order, n));
    for (size_t k = 0; k < n; k++)
        order[k] = (place){variable_of_term(m, i, first + k), first + k};
    qsort(order, n, sizeof *order, by_var);
    mpq_init(scratch);
    for (size_t k = 0; k < n;) {
        int v = order[k].var;
        mpq_set_ui(d->q[d->n], 0, 1);
        for (; k < n && order[k].var == v; k++) {
            m->kind->get(scratch, m->coef, order[k].at);
            mpq_add(d->q[d->n], d->q[d->n], scratch);
        }
        d->var[d->n] = v;
        d->n += mpq_sgn(d->q[d->n]) != 0;
    }
    m->kind->get(d->q[d->n], m->right, i);
    mpq_clear(scratch);
    fmb_mem_put(mem, order, n, sizeof *order);
    return FMB_OK;
}

static fmb_status append_long_row(fmb_system *s, const matrix *m, size_t i, fmb_rel rel)
{
    draft d;
    FMB_TRY(draft_init(&d, first_term(m, i + 1) - first_term(m, i), &s->mem));
    fmb_status st = draft_gather(&d, m, i, &s->mem);
    FMB_THEN(st, draft_append(&d, s, rel));
    draft_clear(&d, &s->mem);
    return st;
}

/* ---- all or none ----------------------------------------------------------------------------- */

static fmb_status append_given_row(fmb_system *s, const matrix *m, size_t i, row_words *w)
{
    size_t n;
    fmb_rel rel = m->rel ? m->rel[i] : FMB_LE;
    if (!take_small_row(m, i, w, &n))
        return append_long_row(s, m, i, rel);
    for (size_t k = 0; is_greater(rel) && k <= n; k++)
        w->z[k] = -w->z[k];
    return fmb_system_append_small(s, n, w->var, w->z, turned(rel));
}

static fmb_status append_matrix(fmb_system *s, const matrix *m)
{
    size_t before = s->rows;
    row_words w = {.most = m->start ? 0 : m->dim};
    for (size_t i = 0; m->start && i < m->rows; i++) {
        size_t n = m->start[i + 1] - m->start[i];
        w.most = n > w.most ? n : w.most;
    }
    w.var = fmb_mem_get(&s->mem, w.most, sizeof *w.var);
    w.z = fmb_mem_get(&s->mem, w.most + 2, sizeof *w.z);
    fmb_status st = w.var && w.z ? FMB_OK : fmb_mem_status(&s->mem);
    for (size_t i = 0; st == FMB_OK && i < m->rows; i++) {
        st = append_given_row(s, m, i, &w);
        if (st == FMB_OK)
            s->row[s->rows - 1].turned = m->rel && is_greater(m->rel[i]);
    }
    while (st != FMB_OK && s->rows > before)
        fmb_system_remove(s, s->rows - 1);
    fmb_mem_put(&s->mem, w.var, w.most, sizeof *w.var);
    fmb_mem_put(&s->mem, w.z, w.most + 2, sizeof *w.z);
    return st;
}

static fmb_status add_matrix(fmb_system *s, matrix m)
{
    m.dim = s ? s->names.size : 0;
    FMB_TRY(check_matrix(s, &m));
    return append_matrix(s, &m);
}

/* ---- the public side ------------------------------------------------------------------------- */

fmb_status fmb_system_add(fmb_system *s, const double *a, fmb_rel rel, double b)
{
    return add_matrix(s, (matrix){&fmb_doubles, 1, NULL, NULL, a, &b, &rel, 0});
}

fmb_status fmb_system_add_int(fmb_system *s, const int64_t *a, fmb_rel rel, int64_t b)
{
    return add_matrix(s, (matrix){&fmb_integers, 1, NULL, NULL, a, &b, &rel, 0});
}

fmb_status fmb_system_add_terms(fmb_system *s, size_t n, const int *var, const double *coef,
                                fmb_rel rel, double b)
{
    const size_t start[] = {0, n};
    return add_matrix(s, (matrix){&fmb_doubles, 1, start, var, coef, &b, &rel, 0});
}

fmb_status fmb_system_add_terms_int(fmb_system *s, size_t n, const int *var, const int64_t *coef,
                                    fmb_rel rel, int64_t b)
{
    const size_t start[] = {0, n};
    return add_matrix(s, (matrix){&fmb_integers, 1, start, var, coef, &b, &rel, 0});
}

fmb_status fmb_system_add_q(fmb_system *s, size_t n, const int *var, mpq_t *coef, fmb_rel rel,
                            const mpq_t b)
{
    const size_t start[] = {0, n};
    return add_matrix(s, (matrix){&fmb_given_rationals, 1, start, var, coef, b, &rel, 0});
}

fmb_status fmb_system_add_rows(fmb_system *s, size_t rows, const size_t *start, const int *var,
                               const double *coef, const fmb_rel *rel, const double *b)
{
    return add_matrix(s, (matrix){&fmb_doubles, rows, start, var, coef, b, rel, 0});
}

fmb_status fmb_system_add_rows_int(fmb_system *s, size_t rows, const size_t *start, const int *var,
                                   const int64_t *coef, const fmb_rel *rel, const int64_t *b)
{
    return add_matrix(s, (matrix){&fmb_integers, rows, start, var, coef, b, rel, 0});
}
