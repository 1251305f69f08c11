/* terms.c: rows whose numbers are text: exact, or refused with an error that names the number. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/io.h>
#include <fmb/session.h>

static fmb_system *open_system(int dim)
{
    fmb_system *s = NULL;
    cr_assert_eq(fmb_system_new(dim, NULL, &s), FMB_OK);
    return s;
}

static void expect_term(const fmb_system *s, size_t i, size_t k, const char *want)
{
    char text[200];
    fmb_system_term_text(s, i, k, text, sizeof text);
    cr_expect_str_eq(text, want, "term %zu of row %zu", k, i);
}

Test(terms, exact)
{
    static const int var[] = {2, 0, 1};
    static const char *const coef[] = {"1/3", "0.1", "-2e3"};
    static const char *const again[] = {"+.5/.25", "123456789012345678901234567890", "0e7"};
    char text[200];
    fmb_system *s = open_system(3);
    cr_assert_eq(fmb_system_add_terms_text(s, 3, var, coef, FMB_GE, "6/4"), FMB_OK);
    cr_assert_eq(fmb_system_add_terms_text(s, 3, var, again, FMB_EQ, "1.5e-3"), FMB_OK);
    cr_assert_eq(fmb_system_add_terms_text(s, 0, NULL, NULL, FMB_LT, "0"), FMB_OK);
    cr_assert_eq(fmb_system_terms(s, 0), 3);
    expect_term(s, 0, 0, "-1/10"); /* >= is turned round */
    expect_term(s, 0, 1, "2000");
    expect_term(s, 0, 2, "-1/3");
    fmb_system_rhs_text(s, 0, text, sizeof text);
    cr_expect_str_eq(text, "-3/2");
    cr_assert_eq(fmb_system_terms(s, 1), 2, "zeros are no terms");
    expect_term(s, 1, 0, "123456789012345678901234567890");
    expect_term(s, 1, 1, "2");
    fmb_system_rhs_text(s, 1, text, sizeof text);
    cr_expect_str_eq(text, "3/2000");
    cr_expect_eq(fmb_system_rel(s, 2), FMB_LT);
    fmb_system_free(s);
}

/* A variable that comes twice is added up; what is read can be written and read again. */
Test(terms, out_and_in_again)
{
    static const int var[] = {1, 1, 0};
    static const char *const coef[] = {"1/3", "1/6", "-7"};
    char text[2][40];
    fmb_system *s = open_system(2);
    cr_assert_eq(fmb_system_add_terms_text(s, 3, var, coef, FMB_LE, "22/7"), FMB_OK);
    expect_term(s, 0, 0, "-7");
    expect_term(s, 0, 1, "1/2");
    for (size_t k = 0; k < 2; k++)
        fmb_system_term_text(s, 0, k, text[k], sizeof text[k]);
    cr_assert_eq(fmb_system_add_terms_text(s, 2, (int[]){0, 1},
                                           (const char *const[]){text[0], text[1]}, FMB_LE, "22/7"),
                 FMB_OK);
    expect_term(s, 1, 0, "-7");
    expect_term(s, 1, 1, "1/2");
    fmb_system_free(s);
}

static void expect_refused(fmb_status want, const char *first, const char *b, int var,
                           const char *words)
{
    fmb_system *s = open_system(2);
    const char *const coef[] = {"1", first};
    fmb_status st =
        fmb_system_add_terms_text(s, 2, (int[]){0, var}, coef, words ? FMB_LE : (fmb_rel)9, b);
    cr_expect_eq(st, want, "%s %s: %d", first, b, (int)st);
    if (words)
        cr_expect_not_null(strstr(fmb_system_trouble(s), words), "\"%s\" instead of \"%s\"",
                           fmb_system_trouble(s), words);
    cr_expect_eq(fmb_system_rows(s), 0, "nothing is appended");
    fmb_system_free(s);
}

Test(terms, refused)
{
    static const char *const wrong[] = {"",     " 1",  "1 ",   "x",      "1x",  "1/", "1/-2",
                                        "--1",  "1e",  "0x10", "inf",    "nan", "-",  "1,5",
                                        "1\n2", "1/x", "\xff", "\x01\n", "1//2"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        expect_refused(FMB_ERR_PARSE, wrong[i], "1", 1, "coefficient of term 1: ");
        expect_refused(FMB_ERR_PARSE, "1", wrong[i], 1, "right side: ");
    }
    expect_refused(FMB_ERR_PARSE, "1/0", "1", 1, "denominator other than zero");
    expect_refused(FMB_ERR_PARSE, "1", "1e999999999", 1, "right side: ");
    expect_refused(FMB_ERR_ARG, NULL, "1", 1, "coefficient of term 1 is NULL");
    expect_refused(FMB_ERR_ARG, "1", NULL, 1, "right side is NULL");
    expect_refused(FMB_ERR_ARG, "1", "1", 2, "variable 2");
    expect_refused(FMB_ERR_ARG, "1", "1", -1, "variable -1");
    expect_refused(FMB_ERR_ARG, "1", "1", 1, NULL);
}

/* ---- systems that are loaded ----------------------------------------------------------------- */

static fmb_solver *load_empty(int dim)
{
    fmb_solver *v = NULL;
    fmb_system *s = open_system(dim);
    cr_assert_eq(fmb_solver_new(NULL, NULL, &v), FMB_OK);
    cr_assert_eq(fmb_solver_add_terms_text(v, 0, NULL, NULL, FMB_LE, "0"), FMB_ERR_STATE);
    cr_assert_eq(fmb_solver_set_right_text(v, 0, "0"), FMB_ERR_STATE);
    cr_assert_eq(fmb_solver_load(v, s), FMB_OK);
    fmb_system_free(s);
    return v;
}

Test(terms, of_a_session)
{
    static const int var[] = {1, 0};
    static const char *const coef[] = {"1/3", "-123456789012345678901234567890"};
    char text[200];
    fmb_solver *v = load_empty(2);
    const fmb_system *s = fmb_solver_system(v);
    cr_assert_eq(fmb_solver_add_terms_text(v, 2, var, coef, FMB_GE, "0.1"), FMB_OK);
    expect_term(s, 0, 0, "123456789012345678901234567890");
    expect_term(s, 0, 1, "-1/3");
    cr_assert_eq(fmb_solver_set_right_text(v, 0, "2/7"), FMB_OK);
    fmb_system_rhs_text(s, 0, text, sizeof text);
    cr_expect_str_eq(text, "-2/7", "in the direction in which the row was given");
    fmb_solver_free(v);
}

static void expect_solver_refuses(fmb_solver *v, fmb_status st, fmb_status want, const char *words)
{
    cr_expect_eq(st, want);
    cr_expect_not_null(strstr(fmb_solver_trouble(v), words), "\"%s\" instead of \"%s\"",
                       fmb_solver_trouble(v), words);
    cr_expect_eq(fmb_system_rows(fmb_solver_system(v)), 0, "nothing is appended");
}

Test(terms, of_a_session_refused)
{
    const char *const one[] = {"1"}, *const bad[] = {"1x"}, *const none[] = {NULL};
    fmb_solver *v = load_empty(1);
    fmb_status (*const add)(fmb_solver *, size_t, const int *, const char *const *, fmb_rel,
                            const char *) = fmb_solver_add_terms_text;
    expect_solver_refuses(v, add(v, 1, (int[]){0}, bad, FMB_LE, "1"), FMB_ERR_PARSE,
                          "coefficient of term 0");
    expect_solver_refuses(v, add(v, 1, (int[]){0}, one, FMB_LE, "1/0"), FMB_ERR_PARSE,
                          "right side");
    expect_solver_refuses(v, add(v, 1, (int[]){0}, none, FMB_LE, "1"), FMB_ERR_ARG,
                          "term 0 is NULL");
    expect_solver_refuses(v, add(v, 1, NULL, one, FMB_LE, "1"), FMB_ERR_ARG, "variables are NULL");
    expect_solver_refuses(v, add(v, 1, (int[]){1}, one, FMB_LE, "1"), FMB_ERR_ARG, "1");
    expect_solver_refuses(v, fmb_solver_set_right_text(v, 0, NULL), FMB_ERR_ARG, "right side");
    expect_solver_refuses(v, fmb_solver_set_right_text(v, 0, "1"), FMB_ERR_ARG, "row is 0");
    fmb_solver_free(v);
}
