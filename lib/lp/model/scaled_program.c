/* scaled_program.c: see scaled_program.h. */
#include "lp/model/scaled_program.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "lp/model/column_units.h"

/* Right sides are limited to this, or they would dwarf all others. */
#define FAR_AWAY 1e60
/* Right sides have a unit if the mean of their exponents is beyond this. */
#define FAR 20
/* Columns are scaled if coefficients of the scaled rows are less than 2^-WIDE. */
#define WIDE 7

void fmb_scaled_program_clear(fmb_scaled_program *f)
{
    FMB_ARRAYS_PUT(f->run->mem, FMB_ARRAY(f->start, f->start_room),
                   FMB_ARRAY(f->value, f->value_room), FMB_ARRAY(f->right, f->right_room),
                   FMB_ARRAY(f->exponent, f->exponent_room), FMB_ARRAY(f->off, f->off_room),
                   FMB_ARRAY(f->column_exponent, f->n));
}

/* ---- numbers --------------------------------------------------------------------------------- */

/* The exponent e of x = f 2^e, 1/2 <= |f| < 1. */
static int exponent_of(double x)
{
    int e = 0;
    frexp(x, &e);
    return x != 0 ? e : 0;
}

/* Coefficient k of a wide row as a number from 1/2 to 1 and a power of two. */
static double split_wide(const fmb_vec *v, size_t k, int *exponent)
{
    long e = 0;
    double fraction = mpz_get_d_2exp(&e, v->z[k]);
    *exponent = (int)e;
    return fraction;
}

/* Term k of the unscaled row, divided by 2^e. */
static double term_divided(const fmb_program_row *row, size_t k, int e)
{
    int own = 0;
    double x = row->value->z ? split_wide(row->value, k, &own) : (double)row->value->s[k];
    return ldexp(x, own - e);
}

/* Write the right side of row i. */
static void scale_right_side(fmb_scaled_program *f, size_t i)
{
    const fmb_program_row *row = &f->p->row[i];
    double right = term_divided(row, row->size, f->exponent[i] + f->unit);
    f->right[i] = fmax(-FAR_AWAY, fmin(FAR_AWAY, right));
}

/* Scale the terms of row i so that its largest fits; its exponent is e before, the result after. */
static int divide_by_largest(const fmb_scaled_program *f, size_t i, int e)
{
    double *value = &f->value[f->start[i]], largest = 0;
    size_t size = f->p->row[i].size;
    for (size_t k = 0; k < size; k++)
        largest = fmax(largest, fabs(value[k]));
    int more = exponent_of(largest);
    double factor = ldexp(1, -more);
    for (size_t k = 0; k < size; k++)
        value[k] *= factor;
    return e + more;
}

/* Columns are scaled first: terms that underflowed before that would be lost. */
static int load_wide_terms(const fmb_scaled_program *f, const fmb_program_row *row, double *value)
{
    int most = INT_MIN, e;
    for (size_t k = 0; k < row->size; k++) {
        split_wide(row->value, k, &e);
        e -= f->column_exponent[row->column[k]];
        most = e > most ? e : most;
    }
    for (size_t k = 0; k < row->size; k++)
        value[k] = term_divided(row, k, most + f->column_exponent[row->column[k]]);
    return row->size > 0 ? most : 0;
}

/* Write the terms and the right side of row i. */
static void load_real_row(fmb_scaled_program *f, size_t i)
{
    const fmb_program_row *row = &f->p->row[i];
    double *value = &f->value[f->start[i]];
    int e = 0;
    if (row->value->z)
        e = load_wide_terms(f, row, value);
    for (size_t k = 0; !row->value->z && k < row->size; k++) {
        int of_column = f->column_exponent[row->column[k]];
        value[k] = (double)row->value->s[k];
        if (of_column != 0) /* rarely, and a call takes longer than all else */
            value[k] = ldexp(value[k], -of_column);
    }
    f->exponent[i] = divide_by_largest(f, i, e);
    scale_right_side(f, i);
    f->off[i] = row->off;
    f->start[i + 1] = f->start[i] + row->size;
}

/* ---- columns --------------------------------------------------------------------------------- */

static double find_least_coefficient(const fmb_scaled_program *f)
{
    double least = 1;
    for (size_t t = 0; t < f->start[f->m]; t++)
        least = fabs(f->value[t]) < least ? fabs(f->value[t]) : least;
    return least;
}

/* The exponent of term k of row i, relative to that of the row. */
static int exponent_of_term(const fmb_scaled_program *f, size_t i, size_t k)
{
    const fmb_program_row *row = &f->p->row[i];
    int own;
    if (!row->value->z)
        return exponent_of(f->value[f->start[i] + k]);
    split_wide(row->value, k, &own);
    return own - f->exponent[i];
}

static size_t read_row_exponents(const void *rows, size_t i, int *column, int *exponent)
{
    const fmb_scaled_program *f = rows;
    size_t size = f->p->row[i].size;
    for (size_t k = 0; k < size; k++) {
        column[k] = fmb_scaled_program_columns(f, i)[k];
        exponent[k] = exponent_of_term(f, i, k);
    }
    return size;
}

/* Compute the exponents of the columns, and matching ones of rows. */
static fmb_status scale_columns(fmb_scaled_program *f)
{
    int *unit;
    FMB_TRY(FMB_GET_ZERO(f->run->mem, unit, f->n));
    fmb_status st = fmb_column_units(f->run->mem, f->run, f->n, f->m, read_row_exponents, f, unit);
    if (st == FMB_OK)
        memcpy(f->column_exponent, unit, f->n * sizeof *unit);
    for (size_t i = 0; st == FMB_OK && i < f->m; i++)
        load_real_row(f, i);
    fmb_mem_put(f->run->mem, unit, f->n, sizeof *unit);
    return st;
}

/* ---- right sides ----------------------------------------------------------------------------- */

/* The mean exponent of right sides of scaled rows, where they are not 0. */
static int mean_exponent_of_right_sides(const fmb_scaled_program *f)
{
    int64_t sum = 0, count = 0;
    for (size_t i = 0; i < f->m; i++) {
        const fmb_program_row *row = &f->p->row[i];
        int own;
        if (row->off || fmb_vec_sgn(row->value, row->size) == 0)
            continue;
        if (row->value->z)
            split_wide(row->value, row->size, &own);
        else
            own = exponent_of((double)row->value->s[row->size]);
        sum += own - f->exponent[i];
        count++;
    }
    return count > 0 ? (int)(sum / count) : 0;
}

static int unit_of_right_sides(const fmb_scaled_program *f)
{
    int mean = mean_exponent_of_right_sides(f);
    return abs(mean) > FAR ? mean : 0;
}

static void scale_right_sides(fmb_scaled_program *f, int unit)
{
    f->unit = unit;
    for (size_t i = 0; i < f->m; i++)
        scale_right_side(f, i);
}

/* ---- as a whole ------------------------------------------------------------------------------ */

static fmb_status reserve_real_rows(fmb_scaled_program *f, size_t m, size_t terms)
{
    fmb_mem *mem = f->run->mem;
    FMB_TRY(FMB_RESERVE(mem, &f->start, &f->start_room, m + 1));
    /* One more, as a row without terms has a place, too. */
    FMB_TRY(FMB_RESERVE(mem, &f->value, &f->value_room, terms + 1));
    FMB_TRY(FMB_RESERVE(mem, &f->right, &f->right_room, m));
    FMB_TRY(FMB_RESERVE(mem, &f->exponent, &f->exponent_room, m));
    return FMB_RESERVE(mem, &f->off, &f->off_room, m);
}

fmb_status fmb_scaled_program_grow(fmb_scaled_program *f)
{
    size_t m = f->p->m, terms = f->m > 0 ? f->start[f->m] : 0;
    for (size_t i = f->m; i < m; i++)
        terms += f->p->row[i].size;
    FMB_TRY(reserve_real_rows(f, m, terms));
    f->start[0] = 0;
    for (; f->m < m; f->m++)
        load_real_row(f, f->m);
    return FMB_OK;
}

fmb_status fmb_scaled_program_append(fmb_scaled_program *f, const double *a, double right)
{
    size_t i = f->m, size = f->p->row[i].size, from = i > 0 ? f->start[i] : 0;
    FMB_TRY(reserve_real_rows(f, i + 1, from + size));
    memcpy(&f->value[from], a, size * sizeof *a);
    f->start[i] = from;
    f->start[i + 1] = from + size;
    f->right[i] = right;
    f->exponent[i] = 0;
    f->off[i] = false;
    f->m++;
    return FMB_OK;
}

fmb_status fmb_scaled_program_init(fmb_scaled_program *f, fmb_run *run, const fmb_program *p)
{
    *f = (fmb_scaled_program){.run = run, .p = p, .n = (size_t)p->n};
    FMB_TRY(FMB_GET_ZERO(run->mem, f->column_exponent, f->n));
    FMB_TRY(fmb_scaled_program_grow(f));
    if (find_least_coefficient(f) < ldexp(1, -WIDE))
        FMB_TRY(scale_columns(f));
    int unit = unit_of_right_sides(f);
    if (unit != 0)
        scale_right_sides(f, unit);
    return FMB_OK;
}

void fmb_scaled_program_shift(fmb_scaled_program *f, const double *right)
{
    if (!right) {
        scale_right_sides(f, unit_of_right_sides(f));
        return;
    }
    f->unit = 0;
    for (size_t i = 0; i < f->m; i++)
        f->right[i] = ldexp(right[i], f->p->row[i].shift - f->exponent[i]);
}

void fmb_scaled_program_shift_row(fmb_scaled_program *f, size_t i)
{
    scale_right_side(f, i);
}

void fmb_scaled_program_move_in(fmb_scaled_program *f, double by)
{
    for (size_t i = 0; i < f->m; i++) {
        double sum = 0;
        for (size_t t = f->start[i]; t < f->start[i + 1]; t++)
            sum += fabs(f->value[t]);
        if (!fmb_scaled_program_is_equality(f, i))
            f->right[i] -= by * sum;
    }
}

bool fmb_scaled_program_has_scaled_columns(const fmb_scaled_program *f)
{
    bool scaled = false;
    for (size_t j = 0; j < f->n; j++)
        scaled |= f->column_exponent[j] != 0;
    return scaled;
}

bool fmb_scaled_program_scale_cost(const fmb_scaled_program *f, const double *cost, double *scaled)
{
    double largest = 0;
    for (size_t j = 0; j < f->n; j++) {
        if (!isfinite(cost[j]))
            return false;
        scaled[j] = ldexp(cost[j], -f->column_exponent[j]);
        largest = fmax(largest, fabs(scaled[j]));
    }
    double factor = ldexp(1, -exponent_of(largest));
    for (size_t j = 0; j < f->n; j++)
        scaled[j] *= factor;
    return isfinite(largest);
}
