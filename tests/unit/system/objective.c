/* objective.c: the objective of a system is read back unchanged, and copied with the system. */
#include <criterion/criterion.h>

#include <math.h>
#include <string.h>

#include "system/system_private.h"

static fmb_system *new_space(int dim)
{
    fmb_system *s;
    cr_assert_eq(fmb_system_new(dim, NULL, &s), FMB_OK);
    return s;
}

static void assert_objective_term(const fmb_system *s, size_t k, int var, long num,
                                  unsigned long den)
{
    mpq_t q;
    mpq_init(q);
    cr_assert_eq(fmb_system_objective_term_q(s, k, q), var);
    cr_assert_eq(mpq_cmp_si(q, num, den), 0);
    mpq_clear(q);
}

static void assert_objective_constant(const fmb_system *s, long num, unsigned long den)
{
    mpq_t q;
    mpq_init(q);
    fmb_system_objective_constant_q(s, q);
    cr_assert_eq(mpq_cmp_si(q, num, den), 0);
    mpq_clear(q);
}

Test(objective, doubles_mean_their_binary_value)
{
    fmb_system *s = new_space(3);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){1, 1, 1}, FMB_LE, 3), FMB_OK);
    cr_assert_eq(fmb_system_sense(s), FMB_SENSE_NONE);
    cr_assert_eq(fmb_system_objective_terms(s), 0);
    assert_objective_constant(s, 0, 1);
    fmb_objective o = {FMB_SENSE_MIN, (double[]){0.5, 0, -3}, 0.25};
    cr_assert_eq(fmb_system_set_objective(s, &o), FMB_OK);
    cr_assert_eq(fmb_system_rows(s), 1, "an objective is no row");
    cr_assert_eq(fmb_system_sense(s), FMB_SENSE_MIN);
    cr_assert_eq(fmb_system_objective_terms(s), 2);
    assert_objective_term(s, 0, 0, 1, 2);
    assert_objective_term(s, 1, 2, -3, 1);
    assert_objective_term(s, 2, -1, 0, 1);
    assert_objective_constant(s, 1, 4);
    cr_assert_eq(fmb_system_set_objective(s, NULL), FMB_OK);
    cr_assert_eq(fmb_system_sense(s), FMB_SENSE_NONE);
    cr_assert_eq(fmb_system_objective_terms(s), 0);
    fmb_system_free(s);
}

Test(objective, rationals_are_added_up_and_replace_the_older_ones)
{
    fmb_system *s = new_space(2);
    mpq_t q[3], constant;
    mpq_inits(q[0], q[1], q[2], constant, NULL);
    mpq_set_si(q[0], 1, 3);
    mpq_set_si(q[1], 5, 1);
    mpq_set_si(q[2], 2, 3);
    mpq_set_si(constant, -7, 2);
    fmb_objective_q o = {FMB_SENSE_MAX, 3, (int[]){1, 0, 1}, q, constant};
    for (int round = 0; round < 2; round++) {
        cr_assert_eq(fmb_system_set_objective_q(s, &o), FMB_OK);
        cr_assert_eq(fmb_system_objective_terms(s), 2);
        assert_objective_term(s, 0, 0, 5, 1);
        assert_objective_term(s, 1, 1, 1, 1);
        assert_objective_constant(s, -7, 2);
    }
    o.constant = NULL;
    o.n = 0;
    cr_assert_eq(fmb_system_set_objective_q(s, &o), FMB_OK);
    cr_assert_eq(fmb_system_sense(s), FMB_SENSE_MAX, "the form 0 is an objective");
    cr_assert_eq(fmb_system_objective_terms(s), 0);
    assert_objective_constant(s, 0, 1);
    cr_assert_eq(fmb_system_set_objective_q(s, NULL), FMB_OK);
    cr_assert_eq(fmb_system_sense(s), FMB_SENSE_NONE);
    mpq_clears(q[0], q[1], q[2], constant, NULL);
    fmb_system_free(s);
}

Test(objective, copies_and_new_variables_keep_it)
{
    fmb_system *s = new_space(2), *t, *empty = new_space(2);
    cr_assert_eq(fmb_system_add_int(s, (int64_t[]){1, 1}, FMB_LE, 3), FMB_OK);
    fmb_objective o = {FMB_SENSE_MAX, (double[]){1, 2}, 3};
    cr_assert_eq(fmb_system_set_objective(s, &o), FMB_OK);
    cr_assert_eq(fmb_system_copy(s, &t), FMB_OK);
    cr_assert_eq(fmb_system_set_objective(s, NULL), FMB_OK);
    cr_assert_eq(fmb_system_rows(t), 1);
    cr_assert_eq(fmb_system_sense(t), FMB_SENSE_MAX);
    cr_assert_eq(fmb_system_add_variable(t, "z", NULL), FMB_OK);
    assert_objective_term(t, 1, 1, 2, 1);
    assert_objective_constant(t, 3, 1);
    cr_assert_eq(fmb_system_join(empty, t, (int[]){1, 0, 0}), FMB_OK);
    cr_assert_eq(fmb_system_sense(empty), FMB_SENSE_NONE, "a join takes rows alone");
    fmb_system_free(empty);
    fmb_system_free(s);
    fmb_system_free(t);
}

Test(objective, bad_ones_leave_the_old_one)
{
    fmb_system *s = new_space(1);
    fmb_objective good = {FMB_SENSE_MAX, (double[]){4}, 0}, bad = good;
    cr_assert_eq(fmb_system_set_objective(s, &good), FMB_OK);
    bad.constant = NAN;
    cr_expect_eq(fmb_system_set_objective(s, &bad), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_system_trouble(s), "constant is nan");
    bad = (fmb_objective){FMB_SENSE_MIN, NULL, 0};
    cr_expect_eq(fmb_system_set_objective(s, &bad), FMB_ERR_ARG);
    bad = (fmb_objective){FMB_SENSE_MIN, (double[]){INFINITY}, 0};
    cr_expect_eq(fmb_system_set_objective(s, &bad), FMB_ERR_ARG);
    cr_expect(strstr(fmb_system_trouble(s), "coefficient of x1 is inf"));
    bad = (fmb_objective){(fmb_sense)7, (double[]){1}, 0};
    cr_expect_eq(fmb_system_set_objective(s, &bad), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_system_trouble(s), "sense 7 is none");
    mpq_t q[1];
    mpq_init(q[0]);
    fmb_objective_q o = {FMB_SENSE_MAX, 1, (int[]){1}, q, NULL};
    cr_expect_eq(fmb_system_set_objective_q(s, &o), FMB_ERR_ARG, "there is no variable 1");
    o.var = (int[]){0};
    mpz_set_ui(mpq_denref(q[0]), 0);
    cr_expect_eq(fmb_system_set_objective_q(s, &o), FMB_ERR_ARG);
    o = (fmb_objective_q){FMB_SENSE_MAX, 0, NULL, NULL, q[0]};
    cr_expect_eq(fmb_system_set_objective_q(s, &o), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_system_trouble(s), "constant has denominator 0");
    o.sense = (fmb_sense)-1;
    cr_expect_eq(fmb_system_set_objective_q(s, &o), FMB_ERR_ARG);
    mpz_set_ui(mpq_denref(q[0]), 1);
    mpq_clear(q[0]);
    cr_expect_eq(fmb_system_rows(s), 0);
    assert_objective_term(s, 0, 0, 4, 1);
    cr_expect_eq(fmb_system_set_objective(NULL, &good), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_set_objective_q(NULL, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_sense(NULL), FMB_SENSE_NONE);
    cr_expect_eq(fmb_system_objective_terms(NULL), 0);
    fmb_system_free(s);
}
