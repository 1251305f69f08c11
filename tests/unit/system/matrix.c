/* matrix.c: rows added by terms and by matrices, of doubles and integers, and read back: they equal
 * rows of rationals, and nothing is appended on failure. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "system/system_private.h"

static fmb_system *open_system(int dim)
{
    fmb_system *s;
    cr_assert_eq(fmb_system_new(dim, NULL, &s), FMB_OK);
    return s;
}

/* Terms and right side of a row by rationals. */
static void add_by_rationals(fmb_system *s, size_t n, const int *var, const double *coef,
                             fmb_rel rel, double b)
{
    mpq_t q[16], right;
    mpq_init(right);
    mpq_set_d(right, b);
    for (size_t k = 0; k < n; k++) {
        mpq_init(q[k]);
        mpq_set_d(q[k], coef[k]);
    }
    cr_assert_eq(fmb_system_add_q(s, n, var, q, rel, right), FMB_OK);
    for (size_t k = 0; k < n; k++)
        mpq_clear(q[k]);
    mpq_clear(right);
}

static void expect_same_row(const fmb_system *s, size_t i, const fmb_system *t, size_t j)
{
    const fmb_sysrow *a = fmb_system_row(s, i), *b = fmb_system_row(t, j);
    cr_assert_eq(a->nnz, b->nnz, "row %zu", i);
    cr_assert_eq(a->rel, b->rel, "row %zu", i);
    cr_assert(a->nnz == 0 || memcmp(a->var, b->var, a->nnz * sizeof *a->var) == 0, "row %zu", i);
    cr_assert(fmb_vec_equal(&a->val, &b->val, a->nnz + 2), "row %zu", i);
}

/* Sorted or not, with zeros, with a variable twice, dyadic or with long numbers. */
Test(matrix, compressed_rows_are_rows_of_terms)
{
    static const size_t start[] = {0, 2, 5, 5, 8, 10, 12, 14};
    static const int var[] = {0, 3, 3, 0, 1, 2, 2, 1, 0, 1, 1, 2, 0, 1};
    static const double coef[] = {1, -2,    0.5,    -0.25,  0,      3,       -3,
                                  7, 1e300, 1e-300, 0x1p61, 0x1p62, 0x1p-61, 0x1p-70};
    static const fmb_rel rel[] = {FMB_LE, FMB_GE, FMB_EQ, FMB_GT, FMB_LT, FMB_GE, FMB_LE};
    static const double b[] = {4, 0.125, -1, 3, 0.1, -0x1p63, 0};
    fmb_system *s = open_system(4), *t = open_system(4), *u = open_system(4);
    cr_assert_eq(fmb_system_add_rows(s, 7, start, var, coef, rel, b), FMB_OK);
    cr_assert_eq(fmb_system_rows(s), 7);
    for (size_t i = 0; i < 7; i++) {
        size_t n = start[i + 1] - start[i];
        add_by_rationals(t, n, var + start[i], coef + start[i], rel[i], b[i]);
        cr_assert_eq(fmb_system_add_terms(u, n, var + start[i], coef + start[i], rel[i], b[i]),
                     FMB_OK);
        expect_same_row(s, i, t, i);
        expect_same_row(u, i, t, i);
    }
    cr_expect_eq(fmb_system_nonzeros(s), 2 + 2 + 0 + 1 + 2 + 2 + 2);
    fmb_system_free(s);
    fmb_system_free(t);
    fmb_system_free(u);
}

/* A matrix of integers, dense or compressed, to both ends of 64 bits, and out again. */
Test(matrix, integers_go_in_and_out)
{
    static const int64_t dense[] = {INT64_MIN, 0, INT64_MAX, 1, 2, 0};
    static const size_t start[] = {0, 2, 4};
    static const int var[] = {2, 0, 0, 1};
    static const int64_t coef[] = {INT64_MAX, INT64_MIN, 1, 2}, b[] = {INT64_MIN, 5};
    fmb_system *s = open_system(3), *t = open_system(3);
    int64_t out[4], right[2];
    int at[4];
    size_t begin[3];
    fmb_rel rel[2];
    cr_assert_eq(fmb_system_add_rows_int(s, 2, NULL, NULL, dense, NULL, b), FMB_OK);
    cr_assert_eq(fmb_system_add_rows_int(t, 2, start, var, coef, NULL, b), FMB_OK);
    expect_same_row(s, 0, t, 0);
    expect_same_row(s, 1, t, 1);
    cr_assert_eq(fmb_system_get_rows_int(s, 0, 2, begin, at, out, rel, right), FMB_OK);
    cr_expect(begin[0] == 0 && begin[1] == 2 && begin[2] == 4);
    cr_expect(at[0] == 0 && at[1] == 2 && at[2] == 0 && at[3] == 1);
    cr_expect(out[0] == INT64_MIN && out[1] == INT64_MAX && out[2] == 1 && out[3] == 2);
    cr_expect(right[0] == INT64_MIN && right[1] == 5 && rel[1] == FMB_LE);
    cr_assert_eq(fmb_system_add_terms_int(s, 1, at, out, FMB_GE, 0), FMB_OK);
    cr_expect_eq(fmb_system_get_rows_int(s, 2, 1, begin, at, out, rel, right), FMB_ERR_RANGE,
                 "2^63 does not fit");
    cr_expect_eq(at[0], 0);
    cr_expect_eq(fmb_system_get_rows_int(s, 2, 1, begin, at, NULL, rel, right), FMB_OK);
    cr_assert_eq(fmb_system_add_terms(s, 1, at, (double[]){0.5}, FMB_LE, 0), FMB_OK);
    cr_expect_eq(fmb_system_get_rows_int(s, 3, 1, NULL, NULL, out, NULL, NULL), FMB_ERR_RANGE);
    cr_expect_eq(fmb_system_get_rows_int(s, 3, 2, NULL, NULL, NULL, NULL, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_get_rows_int(s, 5, 0, NULL, NULL, NULL, NULL, NULL), FMB_ERR_ARG);
    fmb_system_free(s);
    fmb_system_free(t);
}

/* Doubles come out as they went in; text is exact. */
Test(matrix, doubles_and_text_come_out)
{
    static const double dense[] = {0.1, -0x1p-1074, 0, 1e300};
    fmb_system *s = open_system(2);
    double out[3], b[2];
    char text[64] = "as it was";
    cr_assert_eq(fmb_system_add_rows(s, 2, NULL, NULL, dense, NULL, (double[]){0.3, 2}), FMB_OK);
    cr_assert_eq(fmb_system_get_rows(s, 0, 2, NULL, NULL, out, NULL, b), FMB_OK);
    cr_expect(memcmp(out, (double[]){0.1, -0x1p-1074, 1e300}, sizeof out) == 0);
    cr_expect(memcmp(b, (double[]){0.3, 2}, sizeof b) == 0);
    cr_assert_eq(fmb_system_add_terms(s, 1, (int[]){1}, (double[]){-0.75}, FMB_EQ, 0.5), FMB_OK);
    cr_expect_eq(fmb_system_term_text(s, 2, 0, text, 4), 4);
    cr_expect_str_eq(text, "as it was");
    cr_expect_eq(fmb_system_term_text(s, 2, 0, text, 5), 4);
    cr_expect_str_eq(text, "-3/4");
    cr_expect_eq(fmb_system_rhs_text(s, 2, text, sizeof text), 3);
    cr_expect_str_eq(text, "1/2");
    cr_expect_eq(fmb_system_rhs_text(s, 9, text, sizeof text), 1);
    cr_expect_eq(fmb_system_term_text(NULL, 0, 0, NULL, 0), 1);
    fmb_system_free(s);
}

Test(matrix, objectives_go_in_and_out_by_terms)
{
    fmb_system *s = open_system(3);
    int var[2] = {0};
    double coef[2] = {0}, constant = 0;
    char text[8];
    cr_expect_eq(fmb_system_get_objective(s, var, coef, &constant), FMB_SENSE_NONE);
    cr_assert_eq(fmb_system_set_objective_terms(s, FMB_SENSE_MIN, 3, (int[]){2, 0, 2},
                                                (double[]){1, -1, 0.5}, 0.25),
                 FMB_OK);
    cr_expect_eq(fmb_system_objective_terms(s), 2);
    cr_expect_eq(fmb_system_get_objective(s, var, coef, &constant), FMB_SENSE_MIN);
    cr_expect(var[0] == 0 && var[1] == 2 && memcmp(coef, (double[]){-1, 1.5}, sizeof coef) == 0);
    cr_expect_eq(fmb_system_objective_term_text(s, 1, text, sizeof text), 3);
    cr_expect_str_eq(text, "3/2");
    cr_expect_eq(fmb_system_objective_constant_text(s, text, sizeof text), 3);
    cr_expect_str_eq(text, "1/4");
    cr_expect_eq(fmb_system_rows(s), 0);
    fmb_system_free(s);
}

Test(matrix, objectives_go_in_and_out_as_integers)
{
    fmb_system *s = open_system(3);
    int var[2] = {7, 7};
    int64_t coef[2] = {7, 7}, constant = 7;
    cr_expect_eq(fmb_system_get_objective_int(s, var, coef, &constant), FMB_OK);
    cr_expect(var[0] == 7 && coef[0] == 7 && constant == 7, "written, and there is none");
    cr_assert_eq(fmb_system_set_objective_terms_int(s, FMB_SENSE_MAX, 3, (int[]){2, 0, 2},
                                                    (int64_t[]){INT64_MAX, -1, -1}, INT64_MIN),
                 FMB_OK);
    cr_expect_eq(fmb_system_sense(s), FMB_SENSE_MAX);
    cr_expect_eq(fmb_system_get_objective_int(s, var, coef, &constant), FMB_OK);
    cr_expect(var[0] == 0 && var[1] == 2 && coef[0] == -1 && coef[1] == INT64_MAX - 1);
    cr_expect_eq(constant, INT64_MIN);
    cr_expect_eq(fmb_system_get_objective_int(s, NULL, NULL, NULL), FMB_OK);
    cr_expect_eq(fmb_system_get_objective_int(NULL, var, coef, &constant), FMB_ERR_ARG);
    cr_assert_eq(
        fmb_system_set_objective_terms(s, FMB_SENSE_MIN, 2, (int[]){0, 1}, (double[]){2, 0.5}, 3),
        FMB_OK);
    cr_expect_eq(fmb_system_get_objective_int(s, var, coef, &constant), FMB_ERR_RANGE);
    cr_expect_eq(coef[0], -1, "written, and one of them is none");
    cr_expect_eq(fmb_system_get_objective_int(s, var, NULL, &constant), FMB_OK);
    cr_expect(var[1] == 1 && constant == 3);
    cr_assert_eq(
        fmb_system_set_objective_terms_int(s, FMB_SENSE_MAX, 1, (int[]){0}, (int64_t[]){1}, 0),
        FMB_OK);
    cr_assert_eq(fmb_system_set_objective_terms_int(s, FMB_SENSE_MAX, 2, (int[]){1, 1},
                                                    (int64_t[]){INT64_MAX, 1}, 0),
                 FMB_OK);
    cr_expect_eq(fmb_system_get_objective_int(s, NULL, coef, NULL), FMB_ERR_RANGE, "2^63");
    fmb_system_free(s);
}

/* Of fractions of all sizes the double is the nearest: none of its neighbours is nearer. */
Test(matrix, doubles_are_the_nearest)
{
    fmb_system *s = open_system(1);
    mpq_t q, x, far, near;
    mpq_inits(q, x, far, near, NULL);
    uint64_t state = 1;
    for (int round = 0; round < 5000; round++) {
        int64_t part[2];
        for (int k = 0; k < 2; k++) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            part[k] = (int64_t)(state >> (2 + state % 61));
        }
        mpq_set_si(q, part[0], (unsigned long)part[1] + 1);
        mpq_canonicalize(q);
        if (round % 3 == 0) { /* a binary fraction */
            mpq_set_si(q, part[0], 1);
            mpq_div_2exp(q, q, state % 62);
        }
        cr_assert_eq(fmb_system_add_q(s, 0, NULL, NULL, FMB_LE, q), FMB_OK);
        double b;
        cr_assert_eq(fmb_system_get_rows(s, (size_t)round, 1, NULL, NULL, NULL, NULL, &b), FMB_OK);
        mpq_set_d(x, b);
        mpq_sub(near, x, q);
        mpq_abs(near, near);
        for (int side = 0; side < 2; side++) {
            mpq_set_d(far, nextafter(b, side ? INFINITY : -INFINITY));
            mpq_sub(far, far, q);
            mpq_abs(far, far);
            cr_assert_leq(mpq_cmp(near, far), 0, "%a", b);
        }
    }
    mpq_clears(q, x, far, near, NULL);
    fmb_system_free(s);
}

static void expect_refusal(const fmb_system *s, fmb_status st, const char *words)
{
    cr_expect_eq(st, FMB_ERR_ARG, "%s", words);
    cr_expect_not_null(strstr(fmb_system_trouble(s), words), "\"%s\" instead of \"%s\"",
                       fmb_system_trouble(s), words);
    cr_expect_eq(fmb_system_rows(s), 0);
}

Test(matrix, wrong_matrices_append_nothing)
{
    fmb_system *s = open_system(2);
    const size_t start[] = {0, 1, 2}, back[] = {0, 5, 2};
    const int var[] = {1, 0}, far[] = {1, 2}, below[] = {1, -1};
    const double one[] = {1, 1}, nan[] = {1, NAN}, inf[] = {1, -INFINITY};
    const int64_t whole[] = {1, 1};
    const fmb_rel rel[] = {FMB_LE, (fmb_rel)7};
    expect_refusal(s, fmb_system_add_rows(s, 2, start, var, nan, NULL, one),
                   "row 1: coefficient of x1 is nan");
    expect_refusal(s, fmb_system_add_rows(s, 2, start, var, one, NULL, inf),
                   "row 1: right side is -inf");
    expect_refusal(s, fmb_system_add_rows(s, 2, start, far, one, NULL, one),
                   "row 1: term 0 is of variable 2, and the system has 2");
    expect_refusal(s, fmb_system_add_rows_int(s, 2, start, below, whole, NULL, whole),
                   "variable -1");
    expect_refusal(s, fmb_system_add_rows(s, 2, start, var, one, rel, one), "row 1: relation 7");
    expect_refusal(s, fmb_system_add_rows(s, 2, back, NULL, NULL, NULL, one),
                   "row 1: it begins at 5 and ends at 2");
    expect_refusal(s, fmb_system_add_rows(s, SIZE_MAX, NULL, NULL, one, NULL, one), "rows of 2");
    expect_refusal(s, fmb_system_add_rows(s, 2, NULL, var, one, NULL, one), "starts");
    expect_refusal(s, fmb_system_add_rows(s, 2, start, NULL, one, NULL, one), "variables");
    expect_refusal(s, fmb_system_add_rows(s, 2, start, var, NULL, NULL, one), "coefficients");
    expect_refusal(s, fmb_system_add_rows_int(s, 2, start, var, whole, NULL, NULL), "right side");
    expect_refusal(s, fmb_system_set_objective_terms(s, (fmb_sense)9, 0, NULL, NULL, 0), "sense");
    expect_refusal(s, fmb_system_set_objective_terms(s, FMB_SENSE_MAX, 0, NULL, NULL, NAN),
                   "constant");
    cr_expect_eq(fmb_system_add_rows(NULL, 0, NULL, NULL, NULL, NULL, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_get_rows(NULL, 0, 0, NULL, NULL, NULL, NULL, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_add_rows(s, 0, NULL, NULL, NULL, NULL, NULL), FMB_OK);
    fmb_system_free(s);
}

enum { MANY = 20000 };

/* The rows as one object. */
Test(matrix, rows_as_one_object)
{
    fmb_system *s = open_system(2);
    fmb_matrix *m = NULL;
    static const double dense[] = {1, -0.5, 0, 3}, b[] = {2, 0.25};
    const fmb_rel rel[] = {FMB_EQ, FMB_GT};
    cr_assert_eq(fmb_system_add_rows(s, 2, NULL, NULL, dense, rel, b), FMB_OK);
    cr_assert_eq(fmb_system_matrix(s, &m), FMB_OK);
    fmb_system_free(s); /* the matrix has its own */
    cr_expect(m->rows == 2 && m->terms == 3 && m->dim == 2);
    cr_expect(memcmp(m->start, (size_t[]){0, 2, 3}, 3 * sizeof *m->start) == 0);
    cr_expect(memcmp(m->var, (int[]){0, 1, 1}, 3 * sizeof *m->var) == 0);
    cr_expect(memcmp(m->coef, (double[]){1, -0.5, -3}, 3 * sizeof *m->coef) == 0);
    cr_expect(memcmp(m->rel, (fmb_rel[]){FMB_EQ, FMB_LT}, 2 * sizeof *m->rel) == 0);
    cr_expect(memcmp(m->b, (double[]){2, -0.25}, 2 * sizeof *m->b) == 0);
    fmb_matrix_free(m);
    fmb_matrix_free(NULL);
    s = open_system(0);
    cr_assert_eq(fmb_system_matrix(s, &m), FMB_OK);
    cr_expect(m->rows == 0 && m->terms == 0 && m->dim == 0 && m->start[0] == 0);
    fmb_matrix_free(m);
    fmb_system_free(s);
}

/* A large matrix comes out as it went in. */
Test(matrix, many_rows)
{
    fmb_system *s = open_system(MANY + 1);
    static size_t start[MANY + 1], begin[MANY + 1];
    static int var[2 * MANY], at[2 * MANY];
    static double coef[2 * MANY], b[MANY], out[2 * MANY];
    for (size_t i = 0; i < MANY; i++) {
        start[i + 1] = 2 * i + 2;
        var[2 * i] = (int)i;
        var[2 * i + 1] = (int)i + 1;
        coef[2 * i] = 1;
        coef[2 * i + 1] = -0.5;
        b[i] = (double)i / 4;
    }
    cr_assert_eq(fmb_system_add_rows(s, MANY, start, var, coef, NULL, b), FMB_OK);
    cr_expect_eq(fmb_system_nonzeros(s), 2 * MANY);
    cr_assert_eq(fmb_system_get_rows(s, 0, MANY, begin, at, out, NULL, NULL), FMB_OK);
    cr_expect(memcmp(start, begin, sizeof start) == 0 && memcmp(var, at, sizeof var) == 0 &&
              memcmp(coef, out, sizeof coef) == 0);
    fmb_system_free(s);
}
