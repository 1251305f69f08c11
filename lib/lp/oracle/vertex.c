/* vertex.c: see vertex.h. */
#include "lp/oracle/vertex.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"

fmb_status fmb_vertex_init(fmb_vertex *v, fmb_run *run, const fmb_program *p)
{
    fmb_mem *mem = run->mem;
    size_t n = (size_t)p->n;
    *v = (fmb_vertex){.run = run, .p = p, .n = n, .m = p->m};
    mpz_inits(v->den, v->unit, v->sum, NULL);
    mpz_set_ui(v->den, 1);
    mpz_set_ui(v->unit, 1);
    FMB_TRY(fmb_factor_new(run, p, &v->factor));
    FMB_TRY(fmb_integers_init(&v->x, n, mem));
    FMB_TRY(fmb_integers_init(&v->y, n, mem));
    FMB_TRY(fmb_integers_init(&v->right, n, mem));
    v->marks = n + p->m;
    return FMB_ARRAYS(mem, true, FMB_ARRAY(v->basis, n), FMB_ARRAY(v->roughly, n),
                      FMB_ARRAY_ZERO(v->is_basic, v->marks));
}

void fmb_vertex_clear(fmb_vertex *v)
{
    fmb_mem *mem = v->run->mem;
    fmb_factor_free(v->factor);
    fmb_integers_clear(&v->x, mem);
    fmb_integers_clear(&v->y, mem);
    fmb_integers_clear(&v->right, mem);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(v->basis, v->n), FMB_ARRAY(v->roughly, v->n),
                   FMB_ARRAY(v->is_basic, v->marks));
    mpz_clears(v->den, v->unit, v->sum, NULL);
}

fmb_status fmb_vertex_grow(fmb_vertex *v)
{
    size_t marks = v->n + v->p->m, more = v->p->m - v->m;
    FMB_TRY(FMB_RESERVE(v->run->mem, &v->is_basic, &v->marks, marks));
    if (more == 0)
        return FMB_OK;
    memset(v->is_basic + v->n + v->m, 0, more * sizeof *v->is_basic);
    for (size_t r = 0; v->set && r < v->n; r++)
        if (fmb_vertex_is_unit(v, r))
            v->basis[r] += more;
    v->m = v->p->m;
    v->feasible = false;
    return FMB_OK;
}

/* ---- the basis ------------------------------------------------------------------------------- */

static bool *basis_mark(fmb_vertex *v, size_t row)
{
    return &v->is_basic[row < v->m ? v->n + row : row - v->m];
}

static bool is_basis_at_hand(fmb_vertex *v, const size_t *basis)
{
    for (size_t r = 0; v->set && r < v->n; r++)
        if (!*basis_mark(v, basis[r]))
            return false;
    return v->set;
}

static fmb_status factor_basis(fmb_vertex *v)
{
    bool changed;
    v->solved = v->feasible = v->set = false;
    fmb_status st = fmb_factor_set(v->factor, v->basis, &changed);
    memset(v->is_basic, 0, (v->n + v->m) * sizeof *v->is_basic);
    for (size_t r = 0; r < v->n; r++)
        *basis_mark(v, v->basis[r]) = true;
    v->set = st == FMB_OK;
    return st;
}

fmb_status fmb_vertex_set(fmb_vertex *v, const size_t *basis)
{
    if (is_basis_at_hand(v, basis))
        return FMB_OK;
    memcpy(v->basis, basis, v->n * sizeof *basis);
    return factor_basis(v);
}

fmb_status fmb_vertex_replace(fmb_vertex *v, size_t r, size_t i)
{
    v->basis[r] = i;
    v->run->stats.pivots++;
    return factor_basis(v);
}

/* ---- exact solutions ------------------------------------------------------------------------- */

/* num / den times 2^exponent in doubles. */
static double ratio_as_double(const mpz_t num, const mpz_t den, int exponent)
{
    long en, ed;
    double a = mpz_get_d_2exp(&en, num), b = mpz_get_d_2exp(&ed, den);
    long shift = en - ed + exponent;
    return shift > 2000 ? a / b * INFINITY : shift < -2000 ? 0 : ldexp(a / b, (int)shift);
}

fmb_status fmb_vertex_solve(fmb_vertex *v)
{
    if (v->solved)
        return FMB_OK;
    for (size_t r = 0; r < v->n; r++) {
        if (fmb_vertex_is_unit(v, r))
            mpz_set_ui(v->right.z[r], 0);
        else
            fmb_program_get(v->p, v->basis[r], v->p->row[v->basis[r]].size, v->right.z[r]);
    }
    FMB_TRY(fmb_factor_solve(v->factor, v->right.z, v->x.z, v->den));
    FMB_TRY(fmb_integers_settle(&v->x, v->run->mem));
    for (size_t j = 0; j < v->n; j++)
        v->roughly[j] = ratio_as_double(v->x.z[j], v->den, 0);
    v->solved = true;
    return FMB_OK;
}

fmb_status fmb_vertex_price(fmb_vertex *v, mpz_t *cost)
{
    FMB_TRY(fmb_factor_solve_transposed(v->factor, cost, v->y.z, v->unit));
    return fmb_integers_settle(&v->y, v->run->mem);
}

fmb_status fmb_vertex_leave(fmb_vertex *v, size_t r, bool falls, fmb_integers *d, mpz_t den)
{
    for (size_t k = 0; k < v->n; k++)
        mpz_set_si(v->right.z[k], k != r ? 0 : falls ? -1 : 1);
    FMB_TRY(fmb_factor_solve(v->factor, v->right.z, d->z, den));
    return fmb_integers_settle(d, v->run->mem);
}

double fmb_vertex_rough_price(const fmb_vertex *v, size_t r, int exponent)
{
    return ratio_as_double(v->y.z[r], v->unit, exponent);
}

/* ---- the rows -------------------------------------------------------------------------------- */

/* Sign of b_i - a_i.x / den. */
static int slack_sign_at(fmb_vertex *v, size_t i, mpz_t *x, const mpz_t den)
{
    fmb_program_get(v->p, i, v->p->row[i].size, v->sum);
    mpz_mul(v->sum, v->sum, den);
    mpz_neg(v->sum, v->sum);
    fmb_program_add_product(v->p, i, x, v->sum);
    return -mpz_sgn(v->sum);
}

int fmb_vertex_slack_sign(fmb_vertex *v, size_t i)
{
    return slack_sign_at(v, i, v->x.z, v->den);
}

double fmb_vertex_slack(fmb_vertex *v, size_t i)
{
    return fmb_vertex_slack_sign(v, i) == 0 ? 0
                                            : -ratio_as_double(v->sum, v->den, -v->p->row[i].shift);
}

/* The slack of row i in doubles. *sure: its sign is right. Each x, coefficient and product is right
 * up to a factor within 1 +- 2^-51, the x being quotients of truncated numbers; sums of up to size
 * + 1 terms add size + 1 roundings: together less than (size + 8) 2^-50 of the sum of absolute
 * values. An x that underflows has an error of 2^-1075 times 1 + 2^-51 besides, enlarged by its
 * coefficient; a product that does, one of 2^-1075: both are doubled. If x is integral (whole), as
 * coefficients are, and all sums are less than 2^53, nothing is rounded; unless the row is divided.
 * Of such a row numbers may be lost: then nothing is sure. */
static double rough_slack(const fmb_program *p, size_t i, const double *roughly, bool whole,
                          bool *sure)
{
    const fmb_program_row *row = &p->row[i];
    double slack = fmb_program_double(p, i, row->size), all = fabs(slack), weight = 1;
    bool lost = slack == 0 && fmb_vec_sgn(row->value, row->size) != 0;
    for (size_t k = 0; k < row->size; k++) {
        double a = fmb_program_double(p, i, k), t = a * roughly[row->column[k]];
        slack -= t;
        all += fabs(t);
        weight += 1 + fabs(a);
        lost |= a == 0;
    }
    double error = all * (double)(row->size + 8) * 0x1p-50 + weight * 0x1p-1073;
    whole = whole && row->shift == 0;
    *sure = !lost && ((all < 1e300 && fabs(slack) > error) || (whole && all < 0x1p53));
    return slack;
}

/* -1 or 1 if row i is violated, 0 if it holds; *depth: by about how much. */
static int violation_sign(fmb_vertex *v, size_t i, double *depth)
{
    bool sure, equality = v->p->row[i].rel == FMB_EQ;
    *depth = rough_slack(v->p, i, v->roughly, false, &sure);
    int sign = sure ? (*depth > 0) - (*depth < 0) : fmb_vertex_slack_sign(v, i);
    *depth = isnan(*depth) ? 0 : fabs(*depth);
    return sign < 0 ? 1 : sign > 0 && equality ? -1 : 0;
}

fmb_status fmb_vertex_find_violated(fmb_vertex *v, bool first, size_t *row, int *sign)
{
    double depth, most = -1;
    *row = SIZE_MAX;
    for (size_t i = 0; i < v->m && !v->feasible; i++) {
        if (v->p->row[i].off || fmb_vertex_holds(v, i))
            continue;
        FMB_TRY(fmb_run_poll(v->run));
        int s = violation_sign(v, i, &depth);
        fmb_run_count(v->run, 40 + 4 * v->p->row[i].size);
        FMB_TRY(fmb_run_poll_long(v->run, v->sum));
        if (s == 0 || depth <= most)
            continue;
        *row = i;
        *sign = s;
        most = depth;
        if (first)
            return FMB_OK;
    }
    v->feasible = *row == SIZE_MAX;
    return FMB_OK;
}

bool fmb_vertex_is_inside(fmb_vertex *v)
{
    for (size_t i = 0; i < v->m; i++) {
        bool sure, strict = v->p->row[i].rel == FMB_LT && !v->p->row[i].off;
        if (!strict)
            continue;
        if (fmb_vertex_holds(v, i))
            return false;
        double slack = rough_slack(v->p, i, v->roughly, false, &sure);
        if (sure ? slack <= 0 : fmb_vertex_slack_sign(v, i) <= 0)
            return false;
    }
    return true;
}

bool fmb_vertex_is_point_inside(fmb_vertex *v, mpz_t *x, const mpz_t den)
{
    bool inside = true;
    for (size_t i = 0; i < v->p->m && inside; i++)
        if (v->p->row[i].rel == FMB_LT && !v->p->row[i].off)
            inside = slack_sign_at(v, i, x, den) > 0;
    return inside;
}

fmb_status fmb_vertex_try_point(fmb_vertex *v, mpz_t *x, const mpz_t den, double *roughly,
                                bool *holds)
{
    bool whole = mpz_cmp_ui(den, 1) == 0;
    *holds = true;
    for (size_t j = 0; j < v->n; j++)
        roughly[j] = ratio_as_double(x[j], den, 0);
    for (size_t i = 0; i < v->p->m && *holds; i++) {
        bool sure;
        fmb_rel rel = v->p->row[i].rel;
        if (v->p->row[i].off)
            continue;
        double slack = rough_slack(v->p, i, roughly, whole, &sure);
        fmb_run_count(v->run, 40 + 4 * v->p->row[i].size);
        int sign = sure ? (slack > 0) - (slack < 0) : slack_sign_at(v, i, x, den);
        *holds = rel == FMB_EQ ? sign == 0 : rel == FMB_LT ? sign > 0 : sign >= 0;
        FMB_TRY(fmb_run_poll_step(v->run, mpz_size(v->sum) >= FMB_LONG_LIMBS));
    }
    return FMB_OK;
}
