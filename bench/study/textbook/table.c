/* table.c: textbook elimination on dense rational rows; see table.h.
 *
 * Source: Schrijver, Theory of Linear and Integer Programming, 1986, section 12.2. A row is dropped
 * only if it is always true or if another present row with the same left side implies it; no
 * history of rows is used, so both are sound at any time.
 */
#include "study/textbook/table.h"

#include <stdlib.h>

/* ---- life of tables and rows ----------------------------------------------------------------- */

/* Append a row of zeros. */
static fmb_status open_row(study_table *t, fmb_rel rel, study_table_row **out)
{
    fmb_status st =
        fmb_mem_reserve(t->mem, (void **)&t->row, &t->capacity, t->rows + 1, sizeof *t->row);
    if (st != FMB_OK)
        return st;
    study_table_row *r = &t->row[t->rows];
    *r = (study_table_row){.a = fmb_mem_get(t->mem, t->width, sizeof *r->a), .rel = rel};
    if (!r->a)
        return FMB_ERR_MEMORY;
    for (size_t j = 0; j < t->width; j++)
        mpq_init(r->a[j]);
    t->rows++;
    *out = r;
    return FMB_OK;
}

static void put_row(study_table *t, study_table_row *r)
{
    for (size_t j = 0; j < t->width; j++)
        mpq_clear(r->a[j]);
    fmb_mem_put(t->mem, r->a, t->width, sizeof *r->a);
}

void study_table_clear(study_table *t)
{
    for (size_t i = 0; i < t->rows; i++)
        put_row(t, &t->row[i]);
    fmb_mem_put(t->mem, t->row, t->capacity, sizeof *t->row);
}

static fmb_status copy_row(study_table *t, const study_table_row *from)
{
    study_table_row *r = NULL;
    fmb_status st = open_row(t, from->rel, &r);
    for (size_t j = 0; st == FMB_OK && j < t->width; j++)
        mpq_set(r->a[j], from->a[j]);
    return st;
}

fmb_status study_table_copy(study_table *to, const study_table *from)
{
    *to = (study_table){.mem = from->mem, .width = from->width, .max_rows = from->max_rows};
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < from->rows; i++)
        st = copy_row(to, &from->row[i]);
    if (st != FMB_OK)
        study_table_clear(to);
    return st;
}

/* ---- tidying --------------------------------------------------------------------------------- */

/* Index of the first nonzero coefficient, or width - 1 if there is none. */
static size_t leading(const study_table *t, const study_table_row *r)
{
    size_t j = 0;
    while (j < t->width - 1 && mpq_sgn(r->a[j]) == 0)
        j++;
    return j;
}

/* Divide by the |first nonzero coefficient|, an equality by the coefficient itself. */
static void normalise(const study_table *t, study_table_row *r)
{
    size_t first = leading(t, r);
    if (first == t->width - 1)
        return;
    mpq_t by;
    mpq_init(by);
    mpq_set(by, r->a[first]);
    if (r->rel != FMB_EQ)
        mpq_abs(by, by);
    for (size_t j = first; j < t->width; j++)
        mpq_div(r->a[j], r->a[j], by);
    mpq_clear(by);
}

/* 0 <= b with b >= 0, 0 < b with b > 0, 0 = 0. */
static bool always_true(const study_table *t, const study_table_row *r)
{
    int b = mpq_sgn(r->a[t->width - 1]);
    return leading(t, r) == t->width - 1 && (r->rel == FMB_EQ   ? b == 0
                                             : r->rel == FMB_LT ? b > 0
                                                                : b >= 0);
}

/* Does r imply later? Both normalised, with the same left side and r->a[last] <= later->a[last]. */
static bool implies(const study_table *t, const study_table_row *r, const study_table_row *later)
{
    if ((r->rel == FMB_EQ) != (later->rel == FMB_EQ))
        return false;
    for (size_t j = 0; j < t->width - 1; j++)
        if (!mpq_equal(r->a[j], later->a[j]))
            return false;
    return r->rel != FMB_EQ || mpq_equal(r->a[t->width - 1], later->a[t->width - 1]);
}

/* Equalities first, then by left side, right side, and < before <=. The width travels in ctx. */
static int by_tightness(const void *x, const void *y, void *ctx)
{
    const study_table_row *r = x, *q = y;
    size_t width = *(const size_t *)ctx;
    if ((r->rel == FMB_EQ) != (q->rel == FMB_EQ))
        return r->rel == FMB_EQ ? -1 : 1;
    for (size_t j = 0; j < width; j++) {
        int order = mpq_cmp(r->a[j], q->a[j]);
        if (order != 0)
            return order;
    }
    return (q->rel == FMB_LT) - (r->rel == FMB_LT);
}

/* After sorting, rows with equal left sides are adjacent, the tightest first. */
static void tidy(study_table *t)
{
    size_t kept = 0;
    for (size_t i = 0; i < t->rows; i++)
        normalise(t, &t->row[i]);
    if (t->rows > 0)
        qsort_r(t->row, t->rows, sizeof *t->row, by_tightness, &t->width);
    for (size_t i = 0; i < t->rows; i++) {
        study_table_row *r = &t->row[i];
        if (always_true(t, r) || (kept > 0 && implies(t, &t->row[kept - 1], r)))
            put_row(t, r);
        else
            t->row[kept++] = *r;
    }
    t->rows = kept;
}

fmb_status study_table_init(study_table *t, const fmb_system *s, size_t max_rows, fmb_mem *mem)
{
    *t = (study_table){.mem = mem, .width = (size_t)fmb_system_dim(s) + 1, .max_rows = max_rows};
    mpq_t coef;
    mpq_init(coef);
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++) {
        study_table_row *r = NULL;
        st = open_row(t, fmb_system_rel(s, i), &r);
        for (size_t k = 0; st == FMB_OK && k < fmb_system_terms(s, i); k++) {
            int var = fmb_system_term_q(s, i, k, coef);
            mpq_set(r->a[var], coef);
        }
        if (st == FMB_OK)
            fmb_system_rhs_q(s, i, r->a[t->width - 1]);
    }
    mpq_clear(coef);
    if (st == FMB_OK)
        tidy(t);
    else
        study_table_clear(t);
    return st;
}

bool study_table_is_false(const study_table *t)
{
    for (size_t i = 0; i < t->rows; i++)
        if (leading(t, &t->row[i]) == t->width - 1)
            return true;
    return false;
}

/* ---- elimination ----------------------------------------------------------------------------- */

/* out += factor * from */
static void add_multiple(const study_table *t, mpq_t *out, mpq_srcptr factor, mpq_t *from)
{
    mpq_t product;
    mpq_init(product);
    for (size_t j = 0; j < t->width; j++) {
        mpq_mul(product, factor, from[j]);
        mpq_add(out[j], out[j], product);
    }
    mpq_clear(product);
}

/* Solve equality e for v, substitute into every other row, and drop e. */
static void substitute(study_table *t, size_t e, size_t v)
{
    mpq_t factor;
    mpq_init(factor);
    for (size_t i = 0; i < t->rows; i++) {
        if (i == e || mpq_sgn(t->row[i].a[v]) == 0)
            continue;
        mpq_div(factor, t->row[i].a[v], t->row[e].a[v]);
        mpq_neg(factor, factor);
        add_multiple(t, t->row[i].a, factor, t->row[e].a);
    }
    mpq_clear(factor);
    put_row(t, &t->row[e]);
    t->row[e] = t->row[--t->rows];
}

/* Append |l_v| u + |u_v| l, in which v cancels: u_v > 0 > l_v. Strict if either is. */
static fmb_status combine(study_table *t, size_t u, size_t l, size_t v)
{
    bool strict = t->row[u].rel == FMB_LT || t->row[l].rel == FMB_LT;
    study_table_row *r = NULL;
    fmb_status st = open_row(t, strict ? FMB_LT : FMB_LE, &r);
    if (st != FMB_OK)
        return st;
    mpq_t factor;
    mpq_init(factor);
    mpq_neg(factor, t->row[l].a[v]);
    add_multiple(t, r->a, factor, t->row[u].a);
    add_multiple(t, r->a, t->row[u].a[v], t->row[l].a);
    mpq_clear(factor);
    return FMB_OK;
}

/* Numbers of rows in which v has a positive and a negative coefficient, and an equality with v or
 * t->rows if there is none. */
static void count(const study_table *t, size_t v, size_t *positive, size_t *negative,
                  size_t *equality)
{
    *positive = *negative = 0;
    *equality = t->rows;
    for (size_t i = 0; i < t->rows; i++) {
        int sign = mpq_sgn(t->row[i].a[v]);
        *positive += sign > 0;
        *negative += sign < 0;
        if (sign != 0 && t->row[i].rel == FMB_EQ)
            *equality = i;
    }
}

/* Combine every pair of rows with opposite signs, then drop the rows with v. */
static fmb_status pair_all(study_table *t, size_t v)
{
    size_t old = t->rows, kept = 0;
    for (size_t u = 0; u < old; u++)
        for (size_t l = 0; l < old; l++) {
            if (mpq_sgn(t->row[u].a[v]) <= 0 || mpq_sgn(t->row[l].a[v]) >= 0)
                continue;
            fmb_status st = combine(t, u, l, v);
            if (st != FMB_OK)
                return st;
        }
    for (size_t i = 0; i < t->rows; i++)
        if (mpq_sgn(t->row[i].a[v]) != 0)
            put_row(t, &t->row[i]);
        else
            t->row[kept++] = t->row[i];
    t->rows = kept;
    return FMB_OK;
}

static fmb_status eliminate(study_table *t, size_t v)
{
    size_t positive, negative, equality, alive;
    count(t, v, &positive, &negative, &equality);
    if (equality < t->rows) {
        substitute(t, equality, v);
    } else {
        if (__builtin_mul_overflow(positive, negative, &alive) ||
            __builtin_add_overflow(alive, t->rows, &alive))
            return FMB_LIMIT;
        if (t->max_rows > 0 && alive > t->max_rows)
            return FMB_LIMIT;
        fmb_status st = pair_all(t, v);
        if (st != FMB_OK)
            return st;
    }
    tidy(t);
    return FMB_OK;
}

/* The variable not in keep that occurs and makes the fewest pairs; width if none is left. */
static size_t choose(const study_table *t, const bool *keep)
{
    size_t best = t->width, least = SIZE_MAX;
    for (size_t v = 0; v + 1 < t->width; v++) {
        size_t positive, negative, equality;
        count(t, v, &positive, &negative, &equality);
        size_t cost = equality < t->rows ? 0 : positive * negative;
        if (!keep[v] && positive + negative > 0 && cost < least) {
            best = v;
            least = cost;
        }
    }
    return best;
}

fmb_status study_table_project(study_table *t, const bool *keep)
{
    fmb_status st = FMB_OK;
    for (size_t v = choose(t, keep); st == FMB_OK && v < t->width; v = choose(t, keep))
        st = eliminate(t, v);
    return st;
}
