/* by_elimination.c: see by_elimination.h; part of the trusted base, as check.c is. */
#include "proof/by_elimination.h"

#include <stdlib.h>

#include "base/arrays.h"
#include "num/bitset.h"
#include "num/rationals.h"
#include "system/system_private.h"

/* Limit on the operations of an elimination: some seconds, and less than 1 GiB. */
#define MOST_WORK ((uint64_t)1 << 29)

/* a.x <= b, or < b, as z[k + 2]: a in lowest terms; b times a factor; the factor > 0. */
typedef struct said_row {
    fmb_integers z;
    bool strict;
} said_row;

typedef struct matching {
    const fmb_elimination *of;
    const fmb_evidence *e;
    fmb_mem *mem;
    size_t k;       /* kept variables */
    bool *kept;     /* [dim] */
    size_t *column; /* [dim] of a kept variable, */
    size_t *var;    /* [k] and the other way round */
    said_row *said; /* [size] in lexicographic order of a */
    size_t size, capacity;
    mpz_t p, q;
} matching;

/* ---- the rows of claims ---------------------------------------------------------------------- */

static bool names_only_kept(const matching *m, const fmb_claim *c)
{
    bool only = true;
    for (size_t i = 0; only && i < c->terms.size; i++)
        only = c->terms.index[i] < m->of->dim && m->kept[c->terms.index[i]];
    return only;
}

/* Is c a claim IMPLIED about kept variables, or one that relies on such claims alone? */
static bool is_said(const matching *m, const fmb_claim *c)
{
    bool good =
        (c->kind == FMB_CLAIM_IMPLIED || c->kind == FMB_CLAIM_FOLLOWS) && names_only_kept(m, c);
    for (size_t i = 0; good && c->kind == FMB_CLAIM_FOLLOWS && i < c->multipliers.size; i++) {
        size_t on = c->multipliers.index[i];
        good = on < m->e->claims && m->e->claim[on].kind == FMB_CLAIM_IMPLIED &&
               names_only_kept(m, &m->e->claim[on]);
    }
    return good;
}

/* Divide a by its content, which becomes the factor of b and is stored behind b. */
static fmb_status settle_said_row(matching *m, fmb_integers *z)
{
    FMB_TRY(fmb_integers_reduce(z->z, m->k, z->z[m->k + 1], m->of->poll));
    return fmb_integers_settle(z, m->mem);
}

/* sign times the claim's row, in the form of a said_row. */
static fmb_status write_said_row(matching *m, const fmb_claim *c, int sign, fmb_integers *z)
{
    FMB_TRY(fmb_integers_init(z, m->k + 2, m->mem));
    mpz_set(m->p, mpq_denref(c->value));
    for (size_t i = 0; i < c->terms.size; i++)
        mpz_lcm(m->p, m->p, mpq_denref(c->terms.value[i]));
    if (sign < 0)
        mpz_neg(m->p, m->p);
    for (size_t i = 0; i <= c->terms.size; i++) {
        mpq_srcptr from = i < c->terms.size ? c->terms.value[i] : c->value;
        mpz_ptr to = z->z[i < c->terms.size ? m->column[c->terms.index[i]] : m->k];
        mpz_divexact(m->q, m->p, mpq_denref(from));
        mpz_mul(to, m->q, mpq_numref(from));
    }
    return settle_said_row(m, z);
}

static fmb_status add_said_row(matching *m, const fmb_claim *c, int sign)
{
    FMB_TRY(FMB_RESERVE(m->mem, &m->said, &m->capacity, m->size + 1));
    said_row *r = &m->said[m->size++];
    *r = (said_row){.strict = c->rel == FMB_LT};
    FMB_TRY(write_said_row(m, c, sign, &r->z));
    return fmb_poll_ask(m->of->poll);
}

static int compare_left_sides(const fmb_integers *x, const fmb_integers *y)
{
    int order = 0;
    for (size_t j = 0; order == 0 && j + 2 < x->size; j++)
        order = mpz_cmp(x->z[j], y->z[j]);
    return order;
}

static int compare_said_rows(const void *x, const void *y)
{
    return compare_left_sides(&((const said_row *)x)->z, &((const said_row *)y)->z);
}

static fmb_status list_said_rows(matching *m)
{
    for (size_t i = 0; i < m->e->claims; i++) {
        const fmb_claim *c = &m->e->claim[i];
        if (!is_said(m, c))
            continue;
        FMB_TRY(add_said_row(m, c, 1));
        if (c->rel == FMB_EQ)
            FMB_TRY(add_said_row(m, c, -1));
    }
    if (m->size > 1)
        qsort(m->said, m->size, sizeof *m->said, compare_said_rows);
    return FMB_OK;
}

/* ---- the remaining rows ---------------------------------------------------------------------- */

/* z is a, b and s for a row s a.x <= b, or < b. Is there a claim t a.x <= c as tight, that is, with
 * c / t <= b / s? */
static bool is_said_by_some(matching *m, const fmb_integers *z, bool strict)
{
    size_t from = 0, to = m->size;
    while (from < to) {
        size_t middle = from + (to - from) / 2;
        if (compare_left_sides(&m->said[middle].z, z) < 0)
            from = middle + 1;
        else
            to = middle;
    }
    bool found = false;
    for (; !found && from < m->size && compare_left_sides(&m->said[from].z, z) == 0; from++) {
        mpz_t *by = m->said[from].z.z;
        mpz_mul(m->p, by[m->k], z->z[m->k + 1]);
        mpz_mul(m->q, z->z[m->k], by[m->k + 1]);
        int order = mpz_cmp(m->p, m->q);
        found = order < 0 || (order == 0 && (m->said[from].strict || !strict));
    }
    return found;
}

/* For remaining row i, times sign: *good if every point satisfies it, or some claim implies it. */
static fmb_status look_at_row(matching *m, size_t i, int sign, const fmb_unsaid *unsaid, bool *good)
{
    const fmb_eliminated_row *r = &m->of->row[i];
    bool strict = r->rel == FMB_LT, constant = true;
    fmb_integers z;
    fmb_status st = fmb_integers_init(&z, m->k + 2, m->mem);
    for (size_t j = 0; st == FMB_OK && j <= m->k; j++) {
        mpz_ptr to = z.z[j];
        mpz_set(to, r->z.z[j < m->k ? m->var[j] : m->of->dim]);
        if (sign < 0)
            mpz_neg(to, to);
        constant = constant && (j == m->k || mpz_sgn(to) == 0);
    }
    if (st == FMB_OK && constant) {
        int side = mpz_sgn(z.z[m->k]);
        *good = strict ? side > 0 : side >= 0;
    } else if (st == FMB_OK) {
        st = settle_said_row(m, &z);
        *good = st == FMB_OK && is_said_by_some(m, &z, strict);
        for (size_t j = 0; st == FMB_OK && j < m->k; j++)
            mpz_mul(z.z[j], z.z[j], z.z[m->k + 1]);
        if (st == FMB_OK && !*good && unsaid) {
            st = unsaid->tell(unsaid->self, &z, strict);
            *good = true; /* the callback handles the row */
        }
    }
    fmb_integers_clear(&z, m->mem);
    return st == FMB_OK ? fmb_poll_ask(m->of->poll) : st;
}

static bool names_others(const matching *m, const fmb_eliminated_row *r)
{
    bool others = false;
    for (size_t j = 0; !others && j < m->of->dim; j++)
        others = !m->kept[j] && mpz_sgn(r->z.z[j]) != 0;
    return others;
}

static fmb_status look_at_all_rows(matching *m, const fmb_unsaid *unsaid, const char **why)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && !*why && i < m->of->rows; i++) {
        const fmb_eliminated_row *r = &m->of->row[i];
        bool good = !names_others(m, r), back = true;
        if (!good) {
            *why = "some variables are not eliminated";
            return FMB_OK;
        }
        st = look_at_row(m, i, 1, unsaid, &good);
        if (st == FMB_OK && r->rel == FMB_EQ)
            st = look_at_row(m, i, -1, unsaid, &back);
        if (!good || !back)
            *why = "no claim implies some rows that the elimination leaves";
    }
    return st;
}

/* ---- the claim WHOLE ------------------------------------------------------------------------- */

static fmb_status open_matching(matching *m, const fmb_claim *q)
{
    size_t dim = m->of->dim;
    mpz_inits(m->p, m->q, NULL);
    FMB_TRY(FMB_ARRAYS(m->mem, true, FMB_ARRAY_ZERO(m->kept, dim), FMB_ARRAY(m->column, dim),
                       FMB_ARRAY(m->var, m->k)));
    for (size_t i = 0; i < m->k; i++) {
        m->var[i] = q->terms.index[i];
        m->kept[m->var[i]] = true;
        m->column[m->var[i]] = i;
    }
    return FMB_OK;
}

static void close_matching(matching *m)
{
    for (size_t i = 0; i < m->size; i++)
        fmb_integers_clear(&m->said[i].z, m->mem);
    FMB_ARRAYS_PUT(m->mem, FMB_ARRAY(m->said, m->capacity), FMB_ARRAY(m->kept, m->of->dim),
                   FMB_ARRAY(m->column, m->of->dim), FMB_ARRAY(m->var, m->k));
    mpz_clears(m->p, m->q, NULL);
}

fmb_status fmb_by_elimination_match(const fmb_elimination *of, const fmb_evidence *e,
                                    const fmb_claim *q, const fmb_unsaid *unsaid, const char **why)
{
    matching m = {.of = of, .e = e, .mem = of->mem, .k = q->terms.size};
    *why = NULL;
    fmb_status st = open_matching(&m, q);
    FMB_THEN(st, list_said_rows(&m));
    FMB_THEN(st, look_at_all_rows(&m, unsaid, why));
    close_matching(&m);
    return st;
}

/* Order of the steps, by their numbers. */
static int compare_steps(const void *x, const void *y)
{
    mpq_srcptr a = *(const mpq_srcptr *)x, b = *(const mpq_srcptr *)y;
    int order = mpq_cmp(a, b);
    return order != 0 ? order : (a > b) - (a < b);
}

/* Kept variables must not be eliminated: fewer rows would then remain to be checked. */
static bool is_kept(const fmb_claim *q, size_t variable)
{
    return fmb_sparse_find(&q->terms, variable) != NULL;
}

/* Eliminate variables in the order of the numbers beside them. */
static fmb_status go_all_steps(fmb_elimination *of, const fmb_claim *q, const char **why)
{
    const fmb_sparse_vector *steps = &q->point;
    mpq_srcptr *order = fmb_mem_get(of->mem, steps->size, sizeof *order);
    fmb_status st = order ? FMB_OK : fmb_mem_status(of->mem);
    bool done = true;
    for (size_t i = 0; order && i < steps->size; i++)
        order[i] = steps->value[i];
    if (order && steps->size > 1)
        qsort(order, steps->size, sizeof *order, compare_steps);
    for (size_t i = 0; st == FMB_OK && !*why && i < steps->size; i++) {
        size_t at = (size_t)(order[i] - (mpq_srcptr)steps->value);
        size_t variable = steps->index[at];
        if (variable >= of->dim || is_kept(q, variable))
            *why = "a step is of a variable that is kept";
        else
            st = fmb_elimination_go_on(of, variable, &done);
        if (!done)
            *why = "the elimination makes too many rows";
    }
    fmb_mem_put(of->mem, order, steps->size, sizeof *order);
    return st;
}

fmb_status fmb_by_elimination_check(const fmb_system *s, const fmb_evidence *e, const fmb_claim *q,
                                    fmb_mem *mem, const fmb_poll *poll, const char **why)
{
    fmb_elimination of;
    *why = NULL;
    if (fmb_system_rows(s) > MOST_WORK / 16 / ((size_t)fmb_system_dim(s) + 1)) {
        *why = "the system is too large to be eliminated";
        return FMB_OK;
    }
    fmb_status st = fmb_elimination_open(&of, s, MOST_WORK, mem, poll);
    FMB_THEN(st, go_all_steps(&of, q, why));
    if (st == FMB_OK && !*why)
        st = fmb_by_elimination_match(&of, e, q, NULL, why);
    fmb_elimination_close(&of);
    return st;
}

/* ---- claims FOLLOWS -------------------------------------------------------------------------- */

/* sum[dim + 1] += factor times the claim's form and value. */
static void add_claim(mpq_t *sum, size_t dim, const fmb_claim *c, mpq_srcptr factor, mpq_t t)
{
    for (size_t i = 0; i <= c->terms.size; i++) {
        mpq_ptr to = sum[i < c->terms.size ? c->terms.index[i] : dim];
        mpq_mul(t, i < c->terms.size ? c->terms.value[i] : c->value, factor);
        mpq_add(to, to, t);
    }
}

static bool is_inequality_of_system(const fmb_evidence *e, const fmb_claim *c)
{
    bool good = c->kind == FMB_CLAIM_IMPLIED;
    for (size_t i = 0; good && i < c->terms.size; i++)
        good = c->terms.index[i] < (size_t)e->dim;
    return good;
}

/* sum = the claims times their multipliers; *strict: a claim with < has a positive one. */
static const char *add_all_claims(const fmb_evidence *e, const fmb_claim *q, mpq_t *sum, mpq_t t,
                                  const fmb_poll *poll, bool *strict, fmb_status *st)
{
    for (size_t i = 0; *st == FMB_OK && i < q->multipliers.size; i++) {
        size_t on = q->multipliers.index[i];
        int sign = mpq_sgn(q->multipliers.value[i]);
        if (on >= e->claims || !is_inequality_of_system(e, &e->claim[on]))
            return "it leans on a claim that is not 'implied'";
        if (sign < 0 && e->claim[on].rel != FMB_EQ)
            return "the multiplier of an inequality is negative";
        *strict = *strict || (sign > 0 && e->claim[on].rel == FMB_LT);
        add_claim(sum, (size_t)e->dim, &e->claim[on], q->multipliers.value[i], t);
        *st = fmb_poll_ask(poll);
    }
    return NULL;
}

/* sum minus the claim is left.x <= right: is left 0, and right small enough? */
static const char *compare_with_claim(const fmb_evidence *e, const fmb_claim *q, mpq_t *sum,
                                      bool strict)
{
    bool zero = true;
    for (int j = 0; zero && j < e->dim; j++)
        zero = mpq_sgn(sum[j]) == 0;
    int right = mpq_sgn(sum[e->dim]);
    if (!zero)
        return "a combined coefficient is wrong";
    return right > 0 || (right == 0 && q->rel == FMB_LT && !strict)
               ? "the combined right side is too large"
               : NULL;
}

fmb_status fmb_follows_check(const fmb_evidence *e, const fmb_claim *q, fmb_mem *mem,
                             const fmb_poll *poll, const char **why)
{
    mpq_t *sum = NULL, t, minus;
    bool strict = false;
    if (q->rel == FMB_EQ) {
        *why = "the claim is no inequality";
        return FMB_OK;
    }
    fmb_status st = fmb_rationals_new(&sum, (size_t)e->dim + 1, mem);
    if (st != FMB_OK)
        return st;
    mpq_inits(t, minus, NULL);
    mpq_set_si(minus, -1, 1);
    *why = add_all_claims(e, q, sum, t, poll, &strict, &st);
    add_claim(sum, (size_t)e->dim, q, minus, t);
    if (st == FMB_OK && !*why)
        *why = compare_with_claim(e, q, sum, strict);
    mpq_clears(t, minus, NULL);
    fmb_rationals_free(sum, (size_t)e->dim + 1, mem);
    return st;
}
