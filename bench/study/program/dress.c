/* dress.c: rescaled, perturbed and thinned systems. See program.h. */
#include <stdlib.h>

#include "study/program/program.h"
#include "study/program/random.h"

/* The numbers of one row of s, [terms] coefficients and the right side. */
typedef struct row_copy {
    int *var;
    mpq_t *q;
    size_t terms, capacity;
} row_copy;

static fmb_status row_copy_init(row_copy *r, const fmb_system *s)
{
    *r = (row_copy){.capacity = (size_t)fmb_system_dim(s) + 1};
    r->var = malloc(r->capacity * sizeof *r->var);
    r->q = malloc(r->capacity * sizeof *r->q);
    for (size_t k = 0; r->q && k < r->capacity; k++)
        mpq_init(r->q[k]);
    return r->var && r->q ? FMB_OK : FMB_ERR_MEMORY;
}

static void row_copy_clear(row_copy *r)
{
    for (size_t k = 0; r->q && k < r->capacity; k++)
        mpq_clear(r->q[k]);
    free(r->q);
    free(r->var);
}

/* The objective of s, its coefficients those of a row. Errors: MEMORY. */
static fmb_status row_copy_set_objective(row_copy *r, const fmb_system *from, fmb_system *to)
{
    fmb_objective_q o = {
        .sense = fmb_system_sense(from), .n = r->terms, .var = r->var, .coef = r->q};
    fmb_system_objective_constant_q(from, r->q[r->terms]);
    o.constant = r->q[r->terms];
    return fmb_system_set_objective_q(to, &o);
}

static void row_copy_get_objective(row_copy *r, const fmb_system *s)
{
    r->terms = fmb_system_objective_terms(s);
    for (size_t k = 0; k < r->terms; k++)
        r->var[k] = fmb_system_objective_term_q(s, k, r->q[k]);
}

static void row_copy_get(row_copy *r, const fmb_system *s, size_t i)
{
    r->terms = fmb_system_terms(s, i);
    for (size_t k = 0; k < r->terms; k++)
        r->var[k] = fmb_system_term_q(s, i, k, r->q[k]);
    fmb_system_rhs_q(s, i, r->q[r->terms]);
}

/* ---- scales ---------------------------------------------------------------------------------- */

/* q *= 10^power */
static void shift_decimal(mpq_t q, int64_t power, mpz_t scratch)
{
    mpz_ui_pow_ui(scratch, 10, (unsigned long)(power < 0 ? -power : power));
    mpz_ptr to = power < 0 ? mpq_denref(q) : mpq_numref(q);
    mpz_mul(to, to, scratch);
    mpq_canonicalize(q);
}

fmb_status study_system_rescale(const fmb_system *s, int most, uint64_t seed, int *power,
                                fmb_system **out)
{
    study_random g = {seed};
    int dim = fmb_system_dim(s), *column = malloc(((size_t)dim + 1) * sizeof *column);
    fmb_system *t = NULL;
    mpz_t scratch;
    row_copy r;
    mpz_init(scratch);
    fmb_status st = row_copy_init(&r, s);
    if (!column)
        st = FMB_ERR_MEMORY;
    if (st == FMB_OK)
        st = fmb_system_new(dim, NULL, &t);
    for (int j = 0; st == FMB_OK && j < dim; j++) {
        column[j] = (int)study_random_between(&g, -most, most);
        if (power)
            power[j] = column[j];
    }
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++) {
        int64_t whole = study_random_between(&g, -most, most);
        row_copy_get(&r, s, i);
        for (size_t k = 0; k <= r.terms; k++)
            shift_decimal(r.q[k], whole + (k < r.terms ? column[r.var[k]] : 0), scratch);
        st = fmb_system_add_q(t, r.terms, r.var, r.q, fmb_system_rel(s, i), r.q[r.terms]);
    }
    row_copy_get_objective(&r, s);
    for (size_t k = 0; st == FMB_OK && k < r.terms; k++)
        shift_decimal(r.q[k], column[r.var[k]], scratch);
    if (st == FMB_OK)
        st = row_copy_set_objective(&r, s, t);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    row_copy_clear(&r);
    free(column);
    mpz_clear(scratch);
    return st;
}

/* ---- fractions ------------------------------------------------------------------------------- */

/* q becomes p/d, d drawn with the digits of least, p one of the ten integers from floor(q d) on. */
static void make_fraction(mpq_t q, int64_t least, study_random *g, mpz_t d, mpz_t p)
{
    if (mpq_sgn(q) == 0)
        return;
    mpz_set_si(d, study_random_between(g, least, 10 * least - 1));
    mpz_mul(p, mpq_numref(q), d);
    mpz_fdiv_q(p, p, mpq_denref(q));
    mpz_add_ui(p, p, (unsigned long)study_random_between(g, 0, 9));
    mpq_set_num(q, p);
    mpq_set_den(q, d);
    mpq_canonicalize(q);
}

/* The numbers of a row. An equality is multiplied by one factor, as otherwise linearly dependent
 * equalities would contradict each other. */
static void make_fractions(row_copy *r, fmb_rel rel, int64_t least, study_random *g, mpz_t d,
                           mpz_t p)
{
    mpq_t factor;
    mpq_init(factor);
    mpq_set_ui(factor, 1, 1);
    if (rel == FMB_EQ)
        make_fraction(factor, least, g, d, p);
    for (size_t k = 0; k <= r->terms; k++)
        if (rel == FMB_EQ)
            mpq_mul(r->q[k], r->q[k], factor);
        else
            make_fraction(r->q[k], least, g, d, p);
    mpq_clear(factor);
}

fmb_status study_system_fractions(const fmb_system *s, int digits, uint64_t seed, fmb_system **out)
{
    study_random g = {seed};
    fmb_system *t = NULL;
    int64_t least = 1;
    mpz_t d, p;
    row_copy r;
    mpz_inits(d, p, NULL);
    for (int i = 1; i < digits; i++)
        least *= 10;
    fmb_status st = row_copy_init(&r, s);
    if (st == FMB_OK)
        st = fmb_system_new(fmb_system_dim(s), NULL, &t);
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++) {
        row_copy_get(&r, s, i);
        make_fractions(&r, fmb_system_rel(s, i), least, &g, d, p);
        st = fmb_system_add_q(t, r.terms, r.var, r.q, fmb_system_rel(s, i), r.q[r.terms]);
    }
    row_copy_get_objective(&r, s);
    if (st == FMB_OK)
        st = row_copy_set_objective(&r, s, t);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    row_copy_clear(&r);
    mpz_clears(d, p, NULL);
    return st;
}

/* ---- density --------------------------------------------------------------------------------- */

static void thin_row(row_copy *r, int percent, study_random *g)
{
    size_t n = r->terms, spared = n > 0 ? (size_t)study_random_between(g, 0, (int64_t)n - 1) : 0;
    r->terms = 0;
    for (size_t k = 0; k < n; k++)
        if (study_random_chance(g, percent) || k == spared) {
            r->var[r->terms] = r->var[k];
            mpq_swap(r->q[r->terms++], r->q[k]);
        }
    mpq_swap(r->q[r->terms], r->q[n]);
}

fmb_status study_system_thin(const fmb_system *s, int percent, uint64_t seed, fmb_system **out)
{
    row_copy r = {0};
    fmb_system *to = NULL;
    study_random g = {seed};
    fmb_status st = row_copy_init(&r, s);
    if (st == FMB_OK)
        st = fmb_system_new(fmb_system_dim(s), NULL, &to);
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++) {
        row_copy_get(&r, s, i);
        if (fmb_system_rel(s, i) != FMB_EQ)
            thin_row(&r, percent, &g);
        st = fmb_system_add_q(to, r.terms, r.var, r.q, fmb_system_rel(s, i), r.q[r.terms]);
    }
    if (st == FMB_OK) {
        row_copy_get_objective(&r, s);
        st = row_copy_set_objective(&r, s, to);
    }
    row_copy_clear(&r);
    if (st == FMB_OK)
        *out = to;
    else
        fmb_system_free(to);
    return st;
}
