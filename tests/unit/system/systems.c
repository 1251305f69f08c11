/* systems.c: rows are read back unchanged; names are found; copies are independent. */
#include <criterion/criterion.h>

#include <math.h>

#include "system/system_private.h"

static fmb_system *new_system(int dim)
{
    fmb_system *s;
    cr_assert_eq(fmb_system_new(dim, NULL, &s), FMB_OK);
    return s;
}

static void assert_term(const fmb_system *s, size_t i, size_t k, int var, long num,
                        unsigned long den)
{
    mpq_t q;
    mpq_init(q);
    cr_assert_eq(fmb_system_term_q(s, i, k, q), var);
    cr_assert_eq(mpq_cmp_si(q, num, den), 0);
    mpq_clear(q);
}

static void assert_rhs(const fmb_system *s, size_t i, long num, unsigned long den)
{
    mpq_t q;
    mpq_init(q);
    fmb_system_rhs_q(s, i, q);
    cr_assert_eq(mpq_cmp_si(q, num, den), 0);
    mpq_clear(q);
}

Test(system, integer_rows)
{
    fmb_system *s = new_system(3);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){2, 0, -4}, FMB_LE, 6), FMB_OK);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){INT64_MIN, 0, INT64_MAX}, FMB_LT, INT64_MIN),
                 FMB_OK);
    cr_assert_eq(fmb_system_rows(s), 2);
    cr_assert_eq(fmb_system_terms(s, 0), 2);
    assert_term(s, 0, 0, 0, 2, 1);
    assert_term(s, 0, 1, 2, -4, 1);
    assert_rhs(s, 0, 6, 1);
    assert_term(s, 1, 0, 0, INT64_MIN, 1);
    assert_term(s, 1, 1, 2, INT64_MAX, 1);
    cr_assert_eq(fmb_system_rel(s, 1), FMB_LT);
    fmb_system_free(s);
}

/* A greater row is kept as the smaller one of the negatives, whichever numbers it came in. */
Test(system, greater_rows_are_kept_the_other_way)
{
    fmb_system *s = new_system(2);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){INT64_MIN, 3}, FMB_GE, 5), FMB_OK);
    cr_assert_eq(fmb_system_add(s, (double[]){0.5, 0}, FMB_GT, -0.25), FMB_OK);
    mpq_t q[2], b;
    mpq_inits(q[0], q[1], b, NULL);
    mpq_set_si(q[0], 2, 3);
    mpq_set_si(q[1], 1, 3);
    mpq_set_si(b, 7, 1);
    int var[] = {0, 0}; /* adds up to x1 */
    cr_assert_eq(fmb_system_add_q(s, 2, var, q, FMB_GE, b), FMB_OK);
    mpq_clears(q[0], q[1], b, NULL);
    cr_assert_eq(fmb_system_rel(s, 0), FMB_LE);
    cr_assert_eq(fmb_system_rel(s, 1), FMB_LT);
    cr_assert_eq(fmb_system_rel(s, 2), FMB_LE);
    mpq_t term;
    mpq_init(term);
    cr_assert_eq(fmb_system_term_q(s, 0, 0, term), 0);
    cr_assert_eq(mpz_cmp_ui(mpq_numref(term), (unsigned long)INT64_MAX + 1), 0);
    mpq_clear(term);
    assert_term(s, 0, 1, 1, -3, 1);
    assert_rhs(s, 0, -5, 1);
    assert_term(s, 1, 0, 0, -1, 2);
    assert_rhs(s, 1, 1, 4);
    assert_term(s, 2, 0, 0, -1, 1);
    assert_rhs(s, 2, -7, 1);
    fmb_system_free(s);
}

Test(system, doubles_mean_their_binary_value)
{
    fmb_system *s = new_system(2);
    mpq_t q, tenth;
    mpq_inits(q, tenth, NULL);
    cr_assert_eq(fmb_system_add(s, (double[]){0.1, 0.5}, FMB_EQ, -0x1p-1074), FMB_OK);
    fmb_system_term_q(s, 0, 0, q);
    mpq_set_ui(tenth, 1, 10);
    cr_assert(!mpq_equal(q, tenth));
    mpq_set_d(tenth, 0.1);
    cr_assert(mpq_equal(q, tenth));
    assert_term(s, 0, 1, 1, 1, 2);
    fmb_system_rhs_q(s, 0, q);
    mpq_set_d(tenth, -0x1p-1074);
    cr_assert(mpq_equal(q, tenth));
    mpq_clears(q, tenth, NULL);
    fmb_system_free(s);
}

Test(system, bad_numbers_and_relations_add_nothing)
{
    fmb_system *s = new_system(1);
    cr_assert_eq(fmb_system_add(s, (double[]){NAN}, FMB_LE, 0), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_add(s, (double[]){1}, FMB_LE, INFINITY), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_add(s, (double[]){1}, (fmb_rel)7, 0), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){1}, (fmb_rel)-1, 0), FMB_ERR_ARG);
    mpq_t q[1], b;
    mpq_inits(q[0], b, NULL);
    cr_assert_eq(fmb_system_add_q(s, 1, (int[]){1}, q, FMB_LE, b), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_add_q(s, 1, (int[]){-1}, q, FMB_LE, b), FMB_ERR_ARG);
    mpq_clears(q[0], b, NULL);
    cr_assert_eq(fmb_system_rows(s), 0);
    fmb_system_free(s);
    cr_assert_eq(fmb_system_new(-1, NULL, &s), FMB_ERR_ARG);
}

Test(system, terms_are_sorted_and_added_up)
{
    fmb_system *s = new_system(5);
    mpq_t q[5], b;
    mpq_init(b);
    mpq_set_si(b, 7, 4);
    for (int k = 0; k < 5; k++)
        mpq_init(q[k]);
    mpq_set_si(q[0], 1, 2);
    mpq_set_si(q[1], 3, 1);
    mpq_set_si(q[2], 1, 3);
    mpq_set_si(q[3], -3, 1);
    mpq_set_si(q[4], 1, 6);
    cr_assert_eq(fmb_system_add_q(s, 5, (int[]){4, 2, 0, 2, 4}, q, FMB_LE, b), FMB_OK);
    cr_assert_eq(fmb_system_terms(s, 0), 2, "3 x3 - 3 x3 is nothing");
    assert_term(s, 0, 0, 0, 1, 3);
    assert_term(s, 0, 1, 4, 2, 3);
    assert_rhs(s, 0, 7, 4);
    for (int k = 0; k < 5; k++)
        mpq_clear(q[k]);
    mpq_clear(b);
    fmb_system_free(s);
}

Test(system, names)
{
    fmb_system *s = new_system(2);
    int j;
    char name[16];
    cr_assert_str_eq(fmb_system_name(s, 1), "x2");
    cr_assert_eq(fmb_system_find(s, "x1"), 0);
    cr_assert_eq(fmb_system_find(s, "x3"), -1);
    cr_assert_eq(fmb_system_add_variable(s, "speed", &j), FMB_OK);
    cr_assert_eq(j, 2);
    cr_assert_eq(fmb_system_add_variable(s, "speed", &j), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_add_variable(s, "", &j), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_set_name(s, 0, "speed"), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_set_name(s, 2, "speed"), FMB_OK);
    cr_assert_eq(fmb_system_set_name(s, 0, "x4"), FMB_OK);
    cr_assert_eq(fmb_system_find(s, "x1"), -1);
    cr_assert_eq(fmb_system_find(s, "x4"), 0);
    cr_assert_eq(fmb_system_set_name(s, 9, "y"), FMB_ERR_ARG);
    cr_assert_eq(fmb_system_add_variable(s, NULL, NULL), FMB_OK);
    cr_assert_str_eq(fmb_system_name(s, 3), "x4_", "the default name was taken");
    for (int k = 0; k < 3000; k++) {
        snprintf(name, sizeof name, "v%d", k);
        cr_assert_eq(fmb_system_add_variable(s, name, &j), FMB_OK);
        cr_assert_eq(fmb_system_find(s, name), j);
    }
    cr_assert_eq(fmb_system_dim(s), 3004);
    fmb_system_free(s);
}

Test(system, labels_marks_and_copies)
{
    fmb_system *s = new_system(2), *t;
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){1, 1}, FMB_EQ, 1), FMB_OK);
    cr_assert_eq(fmb_system_add(s, (double[]){1e300, 1e-300}, FMB_LT, 3), FMB_OK);
    cr_assert_null(fmb_system_label(s, 0));
    cr_assert_eq(fmb_system_set_label(s, 0, "sum"), FMB_OK);
    cr_assert_eq(fmb_system_set_label(s, 5, "none"), FMB_ERR_ARG);
    cr_assert_not(fmb_system_asks_projection(s));
    fmb_system_set_kept(s, 1, true);
    cr_assert(fmb_system_asks_projection(s) && fmb_system_is_kept(s, 1) &&
              !fmb_system_is_kept(s, 0));
    cr_assert_eq(fmb_system_copy(s, &t), FMB_OK);
    cr_assert_eq(fmb_system_set_label(s, 0, NULL), FMB_OK);
    cr_assert_null(fmb_system_label(s, 0));
    fmb_system_free(s);
    cr_assert_str_eq(fmb_system_label(t, 0), "sum");
    cr_assert(fmb_system_is_kept(t, 1) && !fmb_system_is_kept(t, 0));
    cr_assert_eq(fmb_system_rel(t, 1), FMB_LT);
    assert_rhs(t, 1, 3, 1);
    fmb_system_remove(t, 0);
    cr_assert_eq(fmb_system_rows(t), 1);
    assert_rhs(t, 0, 3, 1);
    fmb_system_free(t);
    fmb_system_free(NULL);
}

/* ---- integers -------------------------------------------------------------------------------- */

/* Marks are false at first, kept by copies and, where either side has one, by joins. */
Test(system, integer_marks)
{
    fmb_system *s = NULL, *copy = NULL, *more = NULL;
    cr_assert(fmb_system_new(3, NULL, &s) == FMB_OK && fmb_system_new(2, NULL, &more) == FMB_OK);
    cr_expect(fmb_system_set_integer(s, 3, true) == FMB_ERR_ARG);
    cr_expect(fmb_system_set_integer(s, -1, true) == FMB_ERR_ARG);
    cr_expect(fmb_system_set_integer(NULL, 0, true) == FMB_ERR_ARG);
    cr_expect(!fmb_system_is_integer(s, 1) && !fmb_system_is_integer(s, 3) &&
              !fmb_system_is_integer(NULL, 0));
    cr_assert(fmb_system_set_integer(s, 1, true) == FMB_OK);
    cr_assert(fmb_system_copy(s, &copy) == FMB_OK);
    cr_expect(!fmb_system_is_integer(copy, 0) && fmb_system_is_integer(copy, 1));
    cr_assert(fmb_system_set_integer(s, 1, false) == FMB_OK);
    cr_expect(!fmb_system_is_integer(s, 1) && fmb_system_is_integer(copy, 1));
    cr_assert(fmb_system_set_integer(more, 0, true) == FMB_OK);
    cr_assert(fmb_system_join(copy, more, (const int[]){2, 1}) == FMB_OK);
    cr_expect(fmb_system_is_integer(copy, 1) && fmb_system_is_integer(copy, 2));
    fmb_system_free(s);
    fmb_system_free(copy);
    fmb_system_free(more);
}
