/* records.c: contents of records of frames in four to eight dimensions, by kernels of every width:
 * held against rationals, the same alone and in a block, and none where there is no inverse. */
#include <criterion/criterion.h>
#include <gmp.h>
#include <math.h>
#include <string.h>

#include "study/draw/pairs.h"
#include "tables.h"

/* ---- records --------------------------------------------------------------------------------- */

enum { MOST = FMB_MINORS_MOST_DIM, NUMBERS = FMB_MINORS_MOST_RECORD };

typedef mpq_t rows[MOST][2 * MOST];

/* Gauss and Jordan: [A | 1] becomes [1 | inverse of A], and A is regular. Returns the sign of its
 * determinant. */
static int invert(int dim, rows x)
{
    int sign = 1;
    mpq_t t;
    mpq_init(t);
    for (int c = 0; c < dim; c++) {
        int p = c;
        while (mpq_sgn(x[p][c]) == 0)
            p++;
        sign *= (p == c ? 1 : -1) * mpq_sgn(x[p][c]);
        for (int j = 0; j < 2 * dim; j++)
            mpq_swap(x[p][j], x[c][j]);
        for (int j = 2 * dim - 1; j >= c; j--)
            mpq_div(x[c][j], x[c][j], x[c][c]);
        for (int r = 0; r < dim; r++)
            for (int j = 2 * dim - 1; r != c && j >= c; j--) {
                mpq_mul(t, x[r][c], x[c][j]);
                mpq_sub(x[r][j], x[r][j], t);
            }
    }
    mpq_clear(t);
    return sign;
}

/* Are these the axes of the frame, perhaps with the first two exchanged? */
static bool are_axes(const fmb_frame *f, const double *axes)
{
    const size_t axis = (size_t)f->dim * sizeof *axes;
    const bool turned = memcmp(axes, f->axes, axis) != 0;
    return memcmp(axes + (turned ? f->dim : 0), f->axes, axis) == 0 &&
           memcmp(axes + (turned ? 0 : f->dim), f->axes + f->dim, axis) == 0 &&
           memcmp(axes + 2 * f->dim, f->axes + 2 * f->dim, (size_t)(f->dim - 2) * axis) == 0;
}

/* Is x a multiple of that power of two? */
static bool is_multiple(double x, double of)
{
    return x / of == rint(x / of);
}

/* What stands behind the size, of whole numbers: is it as kernels/inverse.h says? */
static void expect_whole(const fmb_frame *f, const double *more)
{
    for (int j = 0; j < f->dim * f->dim; j++)
        cr_expect(is_multiple(f->axes[j], more[1]));
    for (int j = 0; j < f->dim; j++)
        cr_expect(is_multiple(f->origin[j], more[1]));
    for (int j = 0; f->speed && j < f->dim; j++)
        cr_expect(is_multiple(f->speed[j], more[1]));
    cr_expect(is_multiple(more[0], more[1]));
}

/* Are all of these multiples of 2^unit, and not all of twice that? */
static bool is_unit(int unit, const double *x, int n)
{
    bool even = true, whole = true;
    for (int i = 0; i < n; i++) {
        whole &= is_multiple(x[i], ldexp(1, unit));
        even &= is_multiple(x[i], ldexp(2, unit));
    }
    return whole && !even;
}

static void expect_units(const fmb_frame *f, double both)
{
    int axes, origin;
    fmb_minors_split_units(both, &axes, &origin);
    cr_expect(is_unit(origin, f->origin, f->dim));
    cr_expect(f->speed || is_unit(axes, f->axes, f->dim * f->dim));
    for (int j = 0; f->speed && j < f->dim * f->dim; j++)
        cr_expect(is_multiple(f->axes[j], ldexp(1, axes)));
    for (int j = 0; f->speed && j < f->dim; j++)
        cr_expect(is_multiple(f->speed[j], ldexp(1, axes)));
}

/* Against the exact one. */
static void expect_inverse(const fmb_frame *f, const double *record)
{
    const int dim = f->dim;
    const double *axes = record + dim, *inverse = record + dim * (dim + 2),
                 *reach = record + 2 * dim * (dim + 1);
    const double *more = record + dim * (2 * dim + 3) + 1;
    rows x;
    mpq_t off;
    mpq_init(off);
    if (more[1] > 0)
        expect_whole(f, more);
    expect_units(f, more[2]);
    for (int r = 0; r < dim; r++)
        for (int c = 0; c < 2 * dim; c++) {
            mpq_init(x[r][c]);
            mpq_set_d(x[r][c], c < dim ? axes[c * dim + r] : c - dim == r);
        }
    cr_expect(are_axes(f, axes));
    cr_expect_eq(invert(dim, x), 1);
    for (int r = 0; r < dim; r++) {
        double error = 0, sum[2] = {0, 0};
        for (int j = 0; j < dim; j++) {
            mpq_set_d(off, more[0]);
            mpq_mul(off, x[r][dim + j], off);
            cr_expect(mpz_cmp_ui(mpq_denref(off), 1) == 0);
            mpq_set_d(off, inverse[r * dim + j]);
            sum[0] += fabs(mpq_get_d(off));
            sum[1] += fabs(mpq_get_d(x[r][dim + j]));
            mpq_sub(off, off, x[r][dim + j]);
            error += fabs(mpq_get_d(off));
        }
        cr_expect_leq(error, 0x1p-52 * reach[r]);
        cr_expect(sum[0] <= reach[r] && sum[1] <= reach[r]);
    }
    for (int r = 0; r < dim; r++)
        for (int c = 0; c < 2 * dim; c++)
            mpq_clear(x[r][c]);
    mpq_clear(off);
}

/* Is a record of a block the same as alone? Every other frame of the block is flat. */
static void expect_same_in_block(kernel_table t, const fmb_frame *f, const double *alone)
{
    double number[8][NUMBERS], *record[8];
    for (unsigned l = 0; l < t.width; l++) {
        record[l] = number[l];
        fmb_inverse_write_frame(f, record[l]);
        for (int j = 0; j < f->dim && l % 2 == 1; j++)
            record[l][f->dim + j] = 0;
    }
    const unsigned good = t.kernels->invert(f->dim, record, t.width);
    cr_expect_eq(good, 0x55U & ((1U << t.width) - 1));
    for (unsigned l = 0; l < t.width; l += 2) {
        fmb_inverse_write_integers(f->dim, record[l]);
        cr_expect_arr_eq(record[l], alone, (size_t)fmb_minors_record(f->dim) * sizeof *alone);
    }
}

Test(records, contents)
{
    int made = 0, whole = 0;
    kernel_table t[4];
    const size_t tables = find_tables(t);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
        for (int i = 0; i < 40; i++) {
            static const study_pair_family family[] = {STUDY_PAIR_ARTICLE, STUDY_PAIR_LATTICE,
                                                       STUDY_PAIR_TOUCHING, STUDY_PAIR_INTEGER};
            const study_pair_plan plan = {.family = family[i % 4], .dim = dim, .moves = i / 4 % 2};
            const kernel_table *by = &t[(size_t)i % tables];
            study_pair p;
            double record[NUMBERS];
            study_pair_draw(&plan, 5, (uint64_t)i, &p);
            if (!make_record(by->kernels, &p.p, record))
                continue;
            made++;
            whole += record[dim * (2 * dim + 3) + 2] > 0;
            expect_inverse(&p.p, record);
            expect_same_in_block(*by, &p.p, record);
        }
    cr_expect_gt(made, 150);
    cr_expect_gt(whole, 40);
}

/* Frames that have no record: too large, too small, too slender, and numbers that are none. */
Test(records, none)
{
    const double bad[] = {NAN, INFINITY, -INFINITY, 0x1p301, 0x1p1023};
    kernel_table t[4];
    const size_t tables = find_tables(t);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
        for (size_t i = 0; i < tables; i++) {
            const study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE, .dim = dim, .moves = true};
            study_pair p;
            double record[NUMBERS];
            study_pair_draw(&plan, 6, i, &p);
            cr_expect(make_record(t[i].kernels, &p.p, record));
            for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
                for (int j = 0; j < dim * (dim + 2); j++) {
                    const double kept = p.number[0][j];
                    p.number[0][j] = bad[k];
                    cr_expect(!make_record(t[i].kernels, &p.p, record));
                    p.number[0][j] = kept;
                }
            double *axes = p.number[0] + (p.p.axes - p.number[0]);
            for (int j = 0; j < dim; j++) /* nearly the second axis */
                axes[j] = axes[dim + j] * (1 + 0x1p-40 * (j == 0));
            cr_expect(!make_record(t[i].kernels, &p.p, record));
            for (int j = 0; j < dim * dim; j++)
                axes[j] = j % (dim + 1) == 0 ? 0x1p-301 : 0;
            cr_expect(!make_record(t[i].kernels, &p.p, record));
        }
}
