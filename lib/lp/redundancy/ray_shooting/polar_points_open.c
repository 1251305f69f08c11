/* polar_points_open.c: see polar_points.h. The interior point comes from
 * lp/redundancy/ray_shooting/centre.h. */
#include "lp/redundancy/ray_shooting/polar_points.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "base/arrays.h"
#include "lp/redundancy/active_set/leading_rows.h"
#include "lp/redundancy/ray_shooting/centre.h"
#include "num/gcd.h"

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_points(fmb_polar_points *p, bool get)
{
    const size_t d = p->d, m = p->m, blocks = p->blocks;
    return FMB_ARRAYS(p->mem, get, FMB_ARRAY(p->exponent, d), FMB_ARRAY(p->order, m),
                      FMB_ARRAY(p->place, m), FMB_ARRAY(p->middle, d * blocks),
                      FMB_ARRAY(p->radius, blocks), FMB_ARRAY(p->reach, blocks),
                      FMB_ARRAY(p->point_at, d * m), FMB_ARRAY(p->round, d * m),
                      FMB_ARRAY(p->size, m), FMB_ARRAY(p->half, d * d), FMB_ARRAY(p->x, d));
}

static fmb_status allocate_points(fmb_polar_points *p)
{
    p->blocks = (p->m + FMB_SPATIAL_BLOCK - 1) / FMB_SPATIAL_BLOCK;
    fmb_status st = hold_points(p, true);
    for (size_t k = 0; p->x && k < p->d; k++)
        mpz_init(p->x[k]);
    return st;
}

void fmb_polar_points_clear(fmb_polar_points *p)
{
    if (!p->mem)
        return;
    for (size_t k = 0; p->x && k < p->d; k++)
        mpz_clear(p->x[k]);
    fmb_mem_put(p->mem, p->column, p->n, sizeof *p->column);
    (void)hold_points(p, false);
    p->mem = NULL;
}

/* ---- rows in doubles ------------------------------------------------------------------------- */

/* List the columns that are not 0, in units that fit all rows, and those that fit right sides. */
static fmb_status choose_units(fmb_polar_points *p)
{
    fmb_leading_rows t;
    fmb_status st = fmb_leading_rows_open(&t, p->mem, p->n, 0);
    if (st == FMB_OK)
        fmb_leading_rows_list_columns(&t, p->n, p->m, p->row);
    FMB_THEN(st, fmb_leading_rows_choose_units(&t, p->m, p->row));
    FMB_THEN(st, FMB_GET(p->mem, p->column, p->n));
    if (st == FMB_OK) {
        p->d = t.n;
        memcpy(p->column, t.column, p->d * sizeof *p->column);
        st = allocate_points(p);
    }
    for (size_t k = 0; st == FMB_OK && k < p->d; k++)
        p->exponent[k] = t.shift[k] - t.shift[t.n];
    fmb_leading_rows_close(&t);
    return st;
}

/* The length of the longest coefficient of row i, in units. */
static int bits_of_row(const fmb_polar_points *p, size_t i)
{
    int most = INT_MIN;
    for (size_t k = 0; k < p->d; k++) {
        int bits = (int)fmb_vec_entry_bits(p->row[i].v, p->column[k]);
        most = bits > 0 && bits - p->exponent[k] > most ? bits - p->exponent[k] : most;
    }
    return most > INT_MIN ? most : 0;
}

/* Load rows scaled to length about 1. False if a right side is beyond doubles. */
static bool load_scaled_rows(fmb_polar_points *p, fmb_centre *c)
{
    for (size_t i = 0; i < p->m; i++) {
        int bits = bits_of_row(p, i);
        for (size_t k = 0; k < p->d; k++)
            c->at[k * c->m + i] =
                fmb_vec_entry_double(p->row[i].v, p->column[k], bits + p->exponent[k]);
        c->right[i] = fmb_vec_entry_double(p->row[i].v, p->n, bits);
    }
    for (size_t i = 0; i < c->m; i++) {
        double square = 0;
        for (size_t k = 0; k < p->d; k++)
            square += c->at[k * c->m + i] * c->at[k * c->m + i];
        double length = sqrt(square);
        for (size_t k = 0; k < p->d; k++)
            c->at[k * c->m + i] /= length;
        c->right[i] /= length;
        if (!(fabs(c->right[i]) < 1e150))
            return false;
    }
    return true;
}

/* ---- the point ------------------------------------------------------------------------------- */

/* Binary places for which rounding does not reach a row: every coordinate changes by less than a
 * quarter of what the row's slack allows. */
static int places_needed(const fmb_centre *c)
{
    double most = 0;
    int places;
    for (size_t i = 0; i < c->m; i++) {
        double sum = 0;
        for (size_t k = 0; k < c->n; k++)
            sum += fabs(c->at[k * c->m + i]);
        most = fmax(most, 2 * sum / c->slack[i]);
    }
    frexp(most, &places);
    return places;
}

/* x / 2^shift = the centre, rounded, no longer in the units of columns. False if the result is
 * beyond doubles. */
static bool round_centre(fmb_polar_points *p, const fmb_centre *c)
{
    int places = places_needed(c);
    p->shift = 0;
    for (size_t k = 0; k < p->d; k++)
        if (places + p->exponent[k] > p->shift)
            p->shift = places + p->exponent[k];
    for (size_t k = 0; k < p->d; k++) {
        int more = p->shift - places - p->exponent[k];
        double whole = nearbyint(ldexp(c->x[k], places));
        if (!isfinite(whole))
            return false;
        mpz_set_d(p->x[k], whole);
        mpz_mul_2exp(p->x[k], p->x[k], (mp_bitcnt_t)more);
    }
    return true;
}

void fmb_polar_points_slack(const fmb_polar_points *p, size_t i, mpz_t slack, mpz_t t)
{
    const fmb_vec *v = p->row[i].v;
    fmb_vec_get(v, p->n, slack);
    mpz_mul_2exp(slack, slack, (mp_bitcnt_t)p->shift);
    for (size_t k = 0; k < p->d; k++) {
        if (fmb_vec_sgn(v, p->column[k]) == 0)
            continue;
        fmb_vec_get(v, p->column[k], t);
        mpz_submul(slack, t, p->x[k]);
    }
}

/* 2^(shift + more) / slack of row i, with two roundings if it is a normal number; 0 if the point is
 * not strictly inside of the row. */
static double inverse_slack(const fmb_polar_points *p, size_t i, int more, mpz_t slack, mpz_t t)
{
    long bits;
    fmb_polar_points_slack(p, i, slack, t);
    if (mpz_sgn(slack) <= 0)
        return 0;
    double head = mpz_get_d_2exp(&bits, slack);
    return ldexp(1 / head, p->shift + more - (int)bits);
}

/* Compute the polar points, by row; false if the point is not strictly inside, or numbers are too
 * large or too small: otherwise no nonzero entry became 0, and an underflow in an entry is less
 * than 2^-594 of the length, which itself has the rounding errors of a sum. */
static bool see_rows(fmb_polar_points *p)
{
    bool inside = true;
    mpz_t slack, t;
    mpz_inits(slack, t, NULL);
    for (size_t i = 0; inside && i < p->m; i++) {
        int bits = bits_of_row(p, i);
        double square = 0, inverse = inverse_slack(p, i, bits, slack, t);
        for (size_t k = 0; k < p->d; k++) {
            double a = fmb_vec_entry_double(p->row[i].v, p->column[k], bits + p->exponent[k]);
            inside &= a != 0 || fmb_vec_sgn(p->row[i].v, p->column[k]) == 0;
            a *= inverse;
            p->point_at[k * p->m + i] = a;
            square += a * a;
        }
        p->size[i] = sqrt(square);
        inside &= isnormal(inverse) && square > 0x1p-960 && square < 1e300;
    }
    mpz_clears(slack, t, NULL);
    return inside;
}

/* round = half^-1 point_at. */
static void make_round(fmb_polar_points *p)
{
    size_t d = p->d;
    memcpy(p->round, p->point_at, d * p->m * sizeof *p->round);
    for (size_t j = 0; j < d; j++) {
        double *row = &p->round[j * p->m], by = 1 / p->half[j * d + j];
        for (size_t k = 0; k < j; k++)
            if (p->half[j * d + k] != 0)
                p->kernels->accumulate(row, &p->round[k * p->m], p->m, -p->half[j * d + k]);
        for (size_t i = 0; i < p->m; i++)
            row[i] *= by;
    }
}

static fmb_status look_from_centre(fmb_polar_points *p, fmb_run *run, fmb_centre *c, bool *inside)
{
    FMB_TRY(fmb_centre_init(c, p->mem, p->d, p->m));
    if (!load_scaled_rows(p, c))
        return FMB_OK;
    FMB_TRY(fmb_centre_find(c, run, inside));
    if (!*inside)
        return FMB_OK;
    *inside = round_centre(p, c) && see_rows(p);
    for (size_t j = 0; j < p->d; j++)
        for (size_t k = 0; k <= j; k++)
            p->half[j * p->d + k] = c->half[j * (c->n + 1) + k];
    if (*inside) {
        fmb_polar_points_arrange(p);
        make_round(p);
    }
    return FMB_OK;
}

fmb_status fmb_polar_points_open(fmb_polar_points *p, fmb_run *run, size_t n, size_t m,
                                 const fmb_lp_row *row, bool *inside)
{
    fmb_centre c = {0};
    *p = (fmb_polar_points){.mem = run->mem, .kernels = run->kernels, .n = n, .m = m, .row = row};
    *inside = false;
    fmb_status st = choose_units(p);
    for (size_t i = 0; st == FMB_OK && i < m; i++)
        if (row[i].rel == FMB_EQ)
            return FMB_OK;
    FMB_THEN(st, look_from_centre(p, run, &c, inside));
    fmb_centre_clear(&c);
    return st;
}

void fmb_polar_points_hide(fmb_polar_points *p, size_t i)
{
    size_t at = p->place[i];
    for (size_t k = 0; k < p->d; k++)
        p->point_at[k * p->m + at] = p->round[k * p->m + at] = 0;
    p->size[at] = 0;
}

void fmb_polar_points_round_point(const fmb_polar_points *p, size_t i, double *q)
{
    for (size_t k = 0; k < p->d; k++)
        q[k] = p->round[k * p->m + p->place[i]];
}

void fmb_polar_points_point(const fmb_polar_points *p, mpq_t *x)
{
    for (size_t j = 0; j < p->n; j++)
        mpq_set_ui(x[j], 0, 1);
    for (size_t k = 0; k < p->d; k++) {
        mpq_set_z(x[p->column[k]], p->x[k]);
        mpq_div_2exp(x[p->column[k]], x[p->column[k]], (mp_bitcnt_t)p->shift);
    }
}
