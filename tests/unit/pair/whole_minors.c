/* whole_minors.c: minors as doubles and by their lowest words (pair/kernels/normal.h), and their
 * signs, against determinants in integers of any length. */
#include <criterion/criterion.h>
#include <gmp.h>
#include <math.h>

#include "pair/kernels/normal.h"
#include "study/draw/draft.h"

/* By Laplace along the first of n rows; columns that are left. */
static void find_det(int dim, int row, unsigned left, const normal_vector *const *v, mpz_t out)
{
    mpz_t part;
    int place = 0;
    mpz_init(part);
    mpz_set_ui(out, row == dim);
    for (int j = 0; row < dim && j < dim; j++) {
        if (!(left >> j & 1))
            continue;
        find_det(dim, row + 1, left & ~(1U << j), v, part);
        mpz_mul_si(part, part, place++ % 2 ? -v[row]->whole[j] : v[row]->whole[j]);
        mpz_add(out, out, part);
    }
    mpz_clear(part);
}

/* A vector of numbers of so many bits; or the sum or difference of two others, some numbers of it
 * one off. */
static void draw_vector(uint64_t *state, int dim, int bits, const normal_vector *others, int n,
                        normal_vector *out)
{
    const bool near = n > 1 && study_splitmix.get(state) % 3 == 0;
    const int64_t sign = study_splitmix.get(state) % 2 ? 1 : -1;
    out->most = 0;
    for (int j = 0; j < dim; j++) {
        out->whole[j] =
            (int64_t)(study_splitmix.get(state) >> (64 - bits)) - (INT64_C(1) << (bits - 1));
        if (near)
            out->whole[j] = others[0].whole[j] + sign * others[n - 1].whole[j] +
                            (study_splitmix.get(state) % (3 * (unsigned)dim) == 0);
        out->near[j] = (double)out->whole[j];
        out->most = fmax(out->most, fabs(out->near[j]));
    }
}

/* The sign of n v, and what its double is off by, against the determinant; v has one bit less. */
static void check_normal(uint64_t *state, int dim, int bits, int seen[3])
{
    normal_vector v[NORMAL_MOST_DIM];
    const normal_vector *row[NORMAL_MOST_DIM];
    normal n;
    double error = 0x1p-53 * normal_error(dim);
    bool is_null = false;
    mpz_t det;
    for (int i = 0; i < dim; i++) {
        draw_vector(state, dim, bits, v, i, &v[i]);
        row[(i + 1) % dim] = &v[i]; /* the last one before the others */
        error *= v[i].most;
    }
    if (normal_words(error) == 0)
        return;
    fmb_normal_begin(normal_words(error), dim, error, &n);
    for (int i = 0; i < dim - 1 && !is_null; i++)
        is_null = fmb_normal_put(i, i, &v[i], &n);
    mpz_init(det);
    find_det(dim, 0, (1U << dim) - 1, row, det);
    if (is_null) {
        cr_expect(mpz_sgn(det) == 0);
    } else {
        const double near = normal_near(&n, v[dim - 1].near);
        cr_expect_eq(fmb_normal_sign(&n, near, error, v[dim - 1].whole), mpz_sgn(det));
        seen[mpz_sgn(det) + 1]++;
        mpz_t whole;
        mpz_init(whole);
        mpz_set_d(whole, rint(near));
        mpz_sub(det, det, whole);
        cr_expect_leq(fabs(mpz_get_d(det)), error + 1);
        mpz_clear(whole);
    }
    mpz_clear(det);
}

Test(minors, whole_minors)
{
    uint64_t state;
    int seen[3] = {0, 0, 0};
    study_splitmix.set(&state, 11);
    for (int dim = FMB_MINORS_LEAST_DIM; dim <= FMB_MINORS_MOST_DIM; dim++)
        for (int i = 0; i < (dim < 7 ? 600 : 20); i++)
            check_normal(&state, dim, 2 + i % 53, seen);
    for (int i = 0; i < 3; i++)
        cr_expect_gt(seen[i], 60);
}
