/* canonical_rows.c: a unique form for each set; see canonical.h.
 *
 * The rows of a set P that is not empty, convex and described by rows <=, < and =:
 *
 * - equations in reduced echelon form: each has a pivot, the first variable that it names, which no
 *   other row names, with a positive coefficient;
 * - inequalities without pivots: one for each facet of the closure of P, strict if the facet is not
 *   in P;
 * - and a strict one for each maximal face of the closure that is not in P and not in a facet that
 *   is not in P: the sum of the rows of all facets that contain the face;
 *
 * all of integers without a common divisor, in the order of fmb_sysrow_compare.
 *
 * Equal sets have equal rows, and the rows describe P: docs/theory.md, theorem 27.
 */
#include "solve/project/canonical.h"

#include "base/arrays.h"
#include "num/gcd.h"
#include "num/integers.h"
#include "num/rationals.h"

/* The equations of the image while they are brought to echelon form. */
typedef struct echelon {
    fmb_claimed_rows *c;
    size_t n, size, rank; /* columns, equations, and equations in echelon form so far */
    fmb_integers *row;    /* [size]: n + 1 entries each */
    mpq_t **of;           /* [size][size] multipliers of the equations; NULL without claims */
    size_t *at;    /* [size] numbers of the equations in the image; in the end of those kept */
    size_t *pivot; /* [rank] columns, increasing */
    mpz_t p, a, g; /* scratch */
    fmb_poll poll; /* the query */
} echelon;

/* ---- equations ------------------------------------------------------------------------------- */

static fmb_status hold_arrays(echelon *e, bool get)
{
    return FMB_ARRAYS_IN_BLOCK(e->c->q->run.mem, get, FMB_ARRAY_ZERO(e->row, e->size),
                               FMB_ARRAY_ZERO(e->of, e->size), FMB_ARRAY(e->at, e->size),
                               FMB_ARRAY(e->pivot, e->size));
}

static fmb_status open_echelon(echelon *e)
{
    fmb_mem *mem = e->c->q->run.mem;
    bool claims = e->c->q->claims != NULL;
    mpz_inits(e->p, e->a, e->g, NULL);
    fmb_status st = hold_arrays(e, true);
    for (size_t i = 0, k = 0; st == FMB_OK && i < e->c->image->rows; i++) {
        if (e->c->image->row[i].rel != FMB_EQ)
            continue;
        e->at[k] = i;
        st = fmb_integers_init(&e->row[k], e->n + 1, mem);
        if (st == FMB_OK && claims)
            st = fmb_rationals_new(&e->of[k], e->size, mem);
        if (st != FMB_OK)
            break;
        fmb_sysrow_expand(&e->c->image->row[i], e->n, e->row[k].z);
        if (claims)
            mpq_set_ui(e->of[k][k], 1, 1);
        st = fmb_integers_settle(&e->row[k++], mem);
    }
    return st;
}

static void close_echelon(echelon *e)
{
    fmb_mem *mem = e->c->q->run.mem;
    for (size_t k = 0; e->row && e->of && k < e->size; k++) {
        fmb_integers_clear(&e->row[k], mem);
        fmb_rationals_free(e->of[k], e->size, mem);
    }
    (void)hold_arrays(e, false);
    mpz_clears(e->p, e->a, e->g, NULL);
}

/* of = (p of - a other) / g, with p, a and g of e; does nothing without claims. */
static void combine_origins(echelon *e, mpq_t *of, mpq_t *other)
{
    mpq_t p, a, t;
    if (!of)
        return;
    mpq_inits(p, a, t, NULL);
    mpq_set_z(p, e->p);
    mpq_set_z(a, e->a);
    mpz_set(mpq_numref(t), e->g);
    mpq_div(p, p, t);
    mpq_div(a, a, t);
    for (size_t k = 0; k < e->size; k++) {
        mpq_mul(of[k], of[k], p);
        if (!other)
            continue;
        mpq_mul(t, other[k], a);
        mpq_sub(of[k], of[k], t);
    }
    mpq_clears(p, a, t, NULL);
}

/* Make entry j of row i zero with row k, whose entry j is not zero. */
static fmb_status clear_entry(echelon *e, size_t i, size_t k, size_t j)
{
    mpz_t *to = e->row[i].z, *by = e->row[k].z;
    FMB_TRY(fmb_long_gcd(e->g, to[j], by[j], &e->poll));
    mpz_divexact(e->p, by[j], e->g);
    mpz_divexact(e->a, to[j], e->g);
    for (size_t c = 0; c <= e->n; c++) {
        if (mpz_sgn(to[c]) != 0)
            mpz_mul(to[c], to[c], e->p);
        if (mpz_sgn(by[c]) != 0)
            mpz_submul(to[c], e->a, by[c]);
    }
    FMB_TRY(fmb_integers_reduce(to, e->n + 1, e->g, &e->poll));
    combine_origins(e, e->of[i], e->of[k]);
    FMB_TRY(fmb_integers_settle(&e->row[i], e->c->q->run.mem));
    return fmb_run_poll(&e->c->q->run);
}

static void swap_equations(echelon *e, size_t i, size_t k)
{
    fmb_integers row = e->row[i];
    mpq_t *of = e->of[i];
    e->row[i] = e->row[k];
    e->of[i] = e->of[k];
    e->row[k] = row;
    e->of[k] = of;
}

/* Gauss-Jordan elimination. */
static fmb_status bring_to_echelon_form(echelon *e)
{
    fmb_status st = FMB_OK;
    for (size_t j = 0; st == FMB_OK && j < e->n && e->rank < e->size; j++) {
        size_t k = e->rank;
        while (k < e->size && mpz_sgn(e->row[k].z[j]) == 0)
            k++;
        if (k == e->size)
            continue;
        swap_equations(e, k, e->rank);
        for (size_t i = 0; st == FMB_OK && i < e->size; i++)
            if (i != e->rank && mpz_sgn(e->row[i].z[j]) != 0)
                st = clear_entry(e, i, e->rank, j);
        e->pivot[e->rank++] = j;
    }
    return st;
}

/* Make the entries coprime and the pivot positive. */
static fmb_status normalize_equation(echelon *e, size_t k)
{
    mpz_t *z = e->row[k].z;
    FMB_TRY(fmb_integers_reduce(z, e->n + 1, e->g, &e->poll));
    mpz_set_si(e->p, mpz_sgn(z[e->pivot[k]]));
    for (size_t j = 0; mpz_sgn(e->p) < 0 && j <= e->n; j++)
        mpz_neg(z[j], z[j]);
    combine_origins(e, e->of[k], NULL);
    return FMB_OK;
}

static fmb_status append_equation(echelon *e, size_t k)
{
    fmb_mem *mem = e->c->q->run.mem;
    fmb_weights w = {0};
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && e->of[k] && i < e->size; i++)
        if (mpq_sgn(e->of[k][i]) != 0)
            st = fmb_weights_add(&w, (uint32_t)e->at[i], e->of[k][i], mem);
    FMB_THEN(st, fmb_claimed_rows_append(e->c, e->row[k].z, FMB_EQ, &w));
    fmb_weights_clear(&w, mem);
    return st;
}

/* The echelon rows replace the first equations; the others, which depend on them, are removed. */
static fmb_status replace_equations(echelon *e)
{
    size_t rows = e->c->image->rows;
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < e->rank; k++) {
        st = normalize_equation(e, k);
        FMB_THEN(st, append_equation(e, k));
    }
    while (st != FMB_OK && e->c->image->rows > rows)
        fmb_claimed_rows_drop(e->c, e->c->image->rows - 1);
    for (size_t k = e->rank; st == FMB_OK && k-- > 0;)
        fmb_claimed_rows_put_last(e->c, e->at[k]);
    for (size_t k = e->size; st == FMB_OK && k-- > e->rank;)
        fmb_claimed_rows_drop(e->c, e->at[k]);
    return st;
}

/* ---- inequalities ---------------------------------------------------------------------------- */

/* Extend the factor e->p of z[], so that equation k can cancel entry pivot[k] in integers. */
static fmb_status multiply_by_pivot(echelon *e, size_t k, mpz_t *z)
{
    mpz_srcptr pivot = e->row[k].z[e->pivot[k]];
    FMB_TRY(fmb_long_gcd(e->g, z[e->pivot[k]], pivot, &e->poll));
    mpz_divexact(e->a, pivot, e->g);
    FMB_TRY(fmb_long_gcd(e->g, e->p, e->a, &e->poll));
    mpz_divexact(e->a, e->a, e->g);
    mpz_mul(e->p, e->p, e->a);
    mpz_abs(e->p, e->p);
    return FMB_OK;
}

/* Make z[] zero in all pivots: z[] is scaled by *own, and w gets the multipliers of equations. */
static fmb_status subtract_equations(echelon *e, mpz_t *z, mpq_t own, fmb_weights *w)
{
    fmb_status st = FMB_OK;
    mpq_t factor;
    mpz_set_ui(e->p, 1);
    for (size_t k = 0; st == FMB_OK && k < e->rank; k++)
        st = multiply_by_pivot(e, k, z);
    if (st != FMB_OK)
        return st;
    for (size_t j = 0; j <= e->n; j++)
        mpz_mul(z[j], z[j], e->p);
    mpq_set_z(own, e->p);
    mpq_init(factor);
    for (size_t k = 0; st == FMB_OK && k < e->rank; k++) {
        mpz_t *by = e->row[k].z;
        if (mpz_sgn(z[e->pivot[k]]) == 0)
            continue;
        mpz_divexact(e->a, z[e->pivot[k]], by[e->pivot[k]]);
        for (size_t j = 0; j <= e->n; j++)
            if (mpz_sgn(by[j]) != 0)
                mpz_submul(z[j], e->a, by[j]);
        mpq_set_z(factor, e->a);
        mpq_neg(factor, factor);
        st = fmb_weights_add(w, (uint32_t)e->at[k], factor, e->c->q->run.mem);
    }
    mpq_clear(factor);
    return st;
}

/* Replace inequality i by its reduced form, which differs; z[n + 1] is scratch. */
static fmb_status reduce_inequality(echelon *e, size_t i, mpz_t *z)
{
    fmb_mem *mem = e->c->q->run.mem;
    fmb_weights w = {0};
    mpq_t own, content;
    mpq_inits(own, content, NULL);
    fmb_sysrow_expand(&e->c->image->row[i], e->n, z);
    fmb_status st = subtract_equations(e, z, own, &w);
    FMB_THEN(st, fmb_weights_add(&w, (uint32_t)i, own, mem));
    FMB_THEN(st, fmb_integers_reduce(z, e->n + 1, mpq_numref(content), &e->poll));
    for (size_t k = 0; st == FMB_OK && k < w.size; k++)
        mpq_div(w.value[k], w.value[k], content);
    FMB_THEN(st, fmb_claimed_rows_append(e->c, z, e->c->image->row[i].rel, &w));
    if (st == FMB_OK)
        fmb_claimed_rows_put_last(e->c, i);
    mpq_clears(own, content, NULL);
    fmb_weights_clear(&w, mem);
    return st == FMB_OK ? fmb_run_poll(&e->c->q->run) : st;
}

/* *reduced: the row names no pivot, and has no common divisor. */
static fmb_status check_row(echelon *e, size_t i, bool *reduced)
{
    const fmb_sysrow *r = &e->c->image->row[i];
    *reduced = false;
    for (size_t k = 0, p = 0; k < r->nnz; k++) {
        while (p < e->rank && e->pivot[p] < (size_t)r->var[k])
            p++;
        if (p < e->rank && e->pivot[p] == (size_t)r->var[k])
            return FMB_OK;
    }
    FMB_TRY(fmb_part_content(e->c->image, i, &e->c->q->run, e->g));
    *reduced = mpz_cmp_ui(e->g, 1) == 0;
    return FMB_OK;
}

static fmb_status reduce_inequalities(echelon *e)
{
    fmb_mem *mem = e->c->q->run.mem;
    fmb_integers z;
    fmb_status st = fmb_integers_init(&z, e->n + 1, mem);
    for (size_t i = 0; st == FMB_OK && i < e->c->image->rows; i++) {
        bool reduced = true;
        if (e->c->image->row[i].rel != FMB_EQ)
            st = check_row(e, i, &reduced);
        if (st != FMB_OK || reduced)
            continue;
        st = reduce_inequality(e, i, z.z);
        FMB_THEN(st, fmb_integers_settle(&z, mem));
    }
    fmb_integers_clear(&z, mem);
    return st;
}

/* ---- all ------------------------------------------------------------------------------------- */

static fmb_status reduce_rows(fmb_claimed_rows *c)
{
    echelon e = {.c = c, .n = (size_t)fmb_system_dim(c->image), .poll = fmb_run_asked(&c->q->run)};
    for (size_t i = 0; i < c->image->rows; i++)
        e.size += c->image->row[i].rel == FMB_EQ;
    fmb_status st = open_echelon(&e);
    FMB_THEN(st, bring_to_echelon_form(&e));
    FMB_THEN(st, replace_equations(&e));
    FMB_THEN(st, reduce_inequalities(&e));
    close_echelon(&e);
    return st;
}

fmb_status fmb_query_canonical(fmb_query *q, const int *place, fmb_system *image)
{
    fmb_claimed_rows c;
    fmb_status st = fmb_claimed_rows_open(&c, q, place, image);
    FMB_THEN(st, reduce_rows(&c));
    FMB_THEN(st, fmb_canonical_faces(&c));
    FMB_THEN(st, fmb_claimed_rows_sort(&c));
    fmb_claimed_rows_close(&c);
    return st;
}
