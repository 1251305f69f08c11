/* round.c: a written system is read back unchanged: random rows with large and small rationals, all
 * relations, awkward names and labels, marks. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

/* splitmix64. */
static uint64_t next(uint64_t *seed)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static size_t below(uint64_t *seed, size_t n)
{
    return (size_t)(next(seed) % n);
}

/* Half of the numbers are small integers, some have hundreds of digits. */
static void random_number(uint64_t *seed, mpq_t q)
{
    mpq_set_si(q, (long)below(seed, 19) - 9, 1);
    if (below(seed, 4) == 0)
        mpq_set_si(q, (long)below(seed, 2001) - 1000, 1 + below(seed, 1000));
    if (below(seed, 8) == 0)
        mpz_ui_pow_ui(mpq_denref(q), 2 + below(seed, 9), below(seed, 300));
    if (below(seed, 8) == 0)
        mpz_ui_pow_ui(mpq_numref(q), 2 + below(seed, 9), below(seed, 300));
    mpq_canonicalize(q);
}

static const char *const words[] = {
    "e3",        "x",     "vars",         "project",   "a b",      " lead",     "trail ",
    "q\"uote\\", "c:d",   "h#sh",         "\xCE\xB1",  "\xff\xfe", "line\nend", "x(1)",
    "1st",       "<=",    "\xE2\x89\xA4", "tab\t",     "e",        ".dot",      "m\xC2\xB7n",
    "-x",        "a'[1]", "\xE2\x82\x81", "eliminate", "x#",       "\\x41",
};

#define WORDS (sizeof words / sizeof *words)

static void random_names(uint64_t *seed, fmb_system *s)
{
    for (int j = 0; j < fmb_system_dim(s); j++)
        if (below(seed, 2) == 0) /* a name that is taken is left */
            (void)!fmb_system_set_name(s, j, words[below(seed, WORDS)]);
}

/* A row, or with a sense the objective. */
static void random_form(uint64_t *seed, fmb_system *s, fmb_sense sense)
{
    enum { MOST = 12 };
    int var[MOST];
    mpq_t coef[MOST], b;
    int dim = fmb_system_dim(s);
    size_t n = dim > 0 ? below(seed, MOST + 1) : 0;
    mpq_init(b);
    random_number(seed, b);
    for (size_t k = 0; k < MOST; k++) {
        mpq_init(coef[k]);
        random_number(seed, coef[k]);
        var[k] = dim > 0 ? (int)below(seed, (size_t)dim) : 0;
    }
    fmb_objective_q o = {sense, n, var, coef, b};
    cr_assert((sense ? fmb_system_set_objective_q(s, &o)
                     : fmb_system_add_q(s, n, var, coef, (fmb_rel)below(seed, 3), b)) == FMB_OK);
    for (size_t k = 0; k < MOST; k++)
        mpq_clear(coef[k]);
    mpq_clear(b);
}

static fmb_system *random_system(uint64_t *seed, bool marks)
{
    fmb_system *s;
    cr_assert(fmb_system_new((int)below(seed, 9), NULL, &s) == FMB_OK);
    random_names(seed, s);
    for (size_t i = below(seed, 12) + (fmb_system_dim(s) == 0); i > 0; i--) {
        random_form(seed, s, FMB_SENSE_NONE);
        const char *label = below(seed, 8) == 0 ? "" : words[below(seed, WORDS)];
        if (below(seed, 2) == 0)
            cr_assert(fmb_system_set_label(s, fmb_system_rows(s) - 1, label) == FMB_OK);
    }
    if (below(seed, 2) == 0)
        random_form(seed, s, below(seed, 2) == 0 ? FMB_SENSE_MAX : FMB_SENSE_MIN);
    bool asks = marks && below(seed, 3) == 0;
    for (int j = 0; asks && j < fmb_system_dim(s); j++)
        fmb_system_set_kept(s, j, below(seed, 2) == 0);
    return s;
}

/* named: names and labels come back; marks: so do marks. */
static void check_round(fmb_format f, bool named, bool marks)
{
    for (uint64_t i = 0; i < 2000 / WATCHED; i++) {
        uint64_t seed = i;
        fmb_system *s = random_system(&seed, marks);
        char *text = write_text(s, f);
        fmb_system *back = parse(f, text, strlen(text));
        cr_assert(same_system(s, back, named), "seed %zu comes back otherwise:\n%s", (size_t)i,
                  text);
        fmb_system *guessed = parse(FMB_FORMAT_AUTO, text, strlen(text));
        cr_assert(same_system(s, guessed, named), "seed %zu is taken for another format:\n%s",
                  (size_t)i, text);
        free(text);
        fmb_system_free(guessed);
        fmb_system_free(back);
        fmb_system_free(s);
    }
}

Test(round, text)
{
    check_round(FMB_FORMAT_TEXT, true, true);
}

/* Names and labels come back where a symbol can spell them: see smt2_symbols. */
Test(round, smt2)
{
    check_round(FMB_FORMAT_SMT2, false, false);
}

Test(round, ine)
{
    check_round(FMB_FORMAT_INE, true, true);
}

/* What SMT-LIB can spell is kept, quoted if need be; other names are replaced, other labels
 * dropped, and so is a label that is taken. */
Test(round, smt2_symbols)
{
    static const char *const name[] = {"x", "a b", "let", "1st", "|", "and", "x5", "\xCE\xB1"};
    static const char *const label[] = {"r", "r", "a b", "x", "not", "b\\c", "(+ 1)"};
    fmb_system *s;
    const double a[8] = {1, -1, 0.5, 0, 2, 0, 0, -3};
    cr_assert(fmb_system_new(0, NULL, &s) == FMB_OK);
    for (size_t j = 0; j < 8; j++)
        cr_assert(fmb_system_add_variable(s, name[j], NULL) == FMB_OK);
    for (size_t i = 0; i < 7; i++) {
        cr_assert(fmb_system_add(s, a, (fmb_rel)(i % 3), -0.25) == FMB_OK);
        cr_assert(fmb_system_set_label(s, i, label[i]) == FMB_OK);
    }
    char *text = write_text(s, FMB_FORMAT_SMT2);
    cr_expect(strstr(text, "(declare-fun |a b| () Real)\n(declare-fun |let| () Real)\n"
                           "(declare-fun |1st| () Real)\n(declare-fun x5_ () Real)\n"
                           "(declare-fun x6 () Real)\n(declare-fun x5 () Real)\n"
                           "(declare-fun |\xCE\xB1| () Real)\n"),
              "%s", text);
    cr_expect(strstr(text, "(assert (! (<= (+ x (- |a b|) (* (/ 1 2) |let|) (* 2 x5_) "
                           "(* (- 3) |\xCE\xB1|)) (- (/ 1 4))) :named r))\n(assert (< "),
              "%s", text);
    fmb_system *back = parse(FMB_FORMAT_SMT2, text, strlen(text));
    cr_expect(same_system(s, back, false));
    cr_expect_str_eq(fmb_system_label(back, 6), "(+ 1)");
    cr_expect(!fmb_system_label(back, 1) && !fmb_system_label(back, 3) &&
              !fmb_system_label(back, 4) && !fmb_system_label(back, 5));
    free(text);
    fmb_system_free(back);
    fmb_system_free(s);
}

/* ---- MPS and LP ------------------------------------------------------------------------------ */

/* No strict rows, at least a variable, and an objective of decimals, in place of what a random
 * system has. */
static fmb_system *random_program(uint64_t *seed)
{
    fmb_system *any = random_system(seed, false), *s;
    mpq_t coef[16], q;
    int var[16];
    cr_assert(fmb_system_new(0, NULL, &s) == FMB_OK);
    mpq_init(q);
    for (int k = 0; k < 16; k++)
        mpq_init(coef[k]);
    for (int j = 0; j < fmb_system_dim(any); j++)
        cr_assert(fmb_system_add_variable(s, fmb_system_name(any, j), NULL) == FMB_OK);
    if (fmb_system_dim(any) == 0)
        cr_assert(fmb_system_add_variable(s, "alone", NULL) == FMB_OK);
    for (size_t i = 0; i < fmb_system_rows(any); i++) {
        size_t n = fmb_system_terms(any, i);
        for (size_t k = 0; k < n; k++)
            var[k] = fmb_system_term_q(any, i, k, coef[k]);
        fmb_system_rhs_q(any, i, q);
        fmb_rel rel = fmb_system_rel(any, i) == FMB_EQ ? FMB_EQ : FMB_LE;
        cr_assert(fmb_system_add_q(s, n, var, coef, rel, q) == FMB_OK);
        cr_assert(fmb_system_set_label(s, i, fmb_system_label(any, i)) == FMB_OK);
    }
    for (int j = 0; j < fmb_system_dim(s); j++)
        cr_assert(fmb_system_set_integer(s, j, below(seed, 3) == 0) == FMB_OK);
    for (int k = 0; k < 2; k++) {
        var[k] = (int)below(seed, (size_t)fmb_system_dim(s));
        mpq_set_si(coef[k], (long)below(seed, 2001) - 1000, 64);
        mpq_canonicalize(coef[k]);
    }
    mpq_set_si(q, (long)below(seed, 21) - 10, 1);
    fmb_objective_q o = {below(seed, 2) ? FMB_SENSE_MAX : FMB_SENSE_MIN, 2, var, coef, q};
    cr_assert(fmb_system_set_objective_q(s, &o) == FMB_OK);
    for (int k = 0; k < 16; k++)
        mpq_clear(coef[k]);
    mpq_clear(q);
    fmb_system_free(any);
    return s;
}

/* a = f b with f > 0, the same for all numbers of a row. */
static bool is_scaled_row(const fmb_system *a, const fmb_system *b, size_t i)
{
    mpq_t p, q, f;
    size_t n = fmb_system_terms(a, i);
    bool same = n == fmb_system_terms(b, i) && fmb_system_rel(a, i) == fmb_system_rel(b, i);
    mpq_inits(p, q, f, NULL);
    for (size_t k = 0; same && k <= n; k++) {
        if (k < n) {
            same = fmb_system_term_q(a, i, k, p) == fmb_system_term_q(b, i, k, q);
        } else {
            fmb_system_rhs_q(a, i, p);
            fmb_system_rhs_q(b, i, q);
        }
        same = same && mpq_sgn(p) == mpq_sgn(q);
        if (!same || mpq_sgn(q) == 0)
            continue;
        mpq_div(p, p, q);
        same = mpq_sgn(f) == 0 || mpq_equal(f, p);
        mpq_set(f, p);
    }
    mpq_clears(p, q, f, NULL);
    return same;
}

static bool is_same_objective(const fmb_system *a, const fmb_system *b)
{
    mpq_t p, q;
    size_t n = fmb_system_objective_terms(a);
    bool same = fmb_system_sense(a) == fmb_system_sense(b) && n == fmb_system_objective_terms(b);
    mpq_inits(p, q, NULL);
    for (size_t k = 0; same && k < n; k++)
        same = fmb_system_objective_term_q(a, k, p) == fmb_system_objective_term_q(b, k, q) &&
               mpq_equal(p, q);
    fmb_system_objective_constant_q(a, p);
    fmb_system_objective_constant_q(b, q);
    same = same && mpq_equal(p, q);
    mpq_clears(p, q, NULL);
    return same;
}

static void check_program_round(fmb_format f)
{
    for (uint64_t i = 0; i < 2000 / WATCHED; i++) {
        uint64_t seed = i;
        fmb_system *s = random_program(&seed);
        char *text = write_text(s, f);
        fmb_system *back = parse(f, text, strlen(text));
        fmb_system *guessed = parse(FMB_FORMAT_AUTO, text, strlen(text));
        cr_assert(fmb_system_dim(back) == fmb_system_dim(s) &&
                      fmb_system_rows(back) == fmb_system_rows(s),
                  "seed %zu: %d variables, %zu rows\n%s", (size_t)i, fmb_system_dim(back),
                  fmb_system_rows(back), text);
        cr_assert(same_system(back, guessed, true), "seed %zu: another format?\n%s", (size_t)i,
                  text);
        for (size_t r = 0; r < fmb_system_rows(s); r++)
            cr_assert(is_scaled_row(s, back, r), "seed %zu, row %zu:\n%s", (size_t)i, r + 1, text);
        for (int j = 0; j < fmb_system_dim(s); j++)
            cr_assert(fmb_system_is_integer(s, j) == fmb_system_is_integer(back, j), "%s", text);
        cr_assert(is_same_objective(s, back), "seed %zu:\n%s", (size_t)i, text);
        free(text);
        fmb_system_free(guessed);
        fmb_system_free(back);
        fmb_system_free(s);
    }
}

Test(round, mps)
{
    check_program_round(FMB_FORMAT_MPS);
}

Test(round, lp)
{
    check_program_round(FMB_FORMAT_LP);
}

static bool is_refused(const char *text, fmb_format f)
{
    char *written = NULL;
    size_t size;
    fmb_system *s = parse(FMB_FORMAT_TEXT, text, strlen(text));
    FILE *out = open_memstream(&written, &size);
    fmb_status st = fmb_system_write(s, f, out);
    fclose(out);
    cr_expect(st == FMB_OK || (st == FMB_ERR_ARG && size == 0), "%s: %s", text, written);
    free(written);
    fmb_system_free(s);
    return st == FMB_ERR_ARG;
}

/* Neither format knows strict rows or fractions in an objective, which cannot be scaled. */
Test(round, programs_refused)
{
    static const char *const texts[] = {"x < 1", "0 <= -1", "max: x/3\nx <= 1",
                                        "min: x + 1/7\nx <= 1"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        cr_expect(is_refused(texts[i], FMB_FORMAT_MPS) && is_refused(texts[i], FMB_FORMAT_LP), "%s",
                  texts[i]);
    cr_expect(is_refused("vars: x", FMB_FORMAT_MPS) && !is_refused("vars: x", FMB_FORMAT_LP));
    cr_expect(!is_refused("x/3 <= 1/7", FMB_FORMAT_MPS) &&
              !is_refused("x/3 <= 1/7", FMB_FORMAT_LP));
}

/* Names and labels that a format can spell are kept, and none is lost to one that is made up. */
Test(round, program_names)
{
    static const char text[] = "vars: \"a b\" x1 end \"1st\" x4\n\"a c\": x1 + \"a b\" <= 1\n"
                               "cap: end <= 1/3\ncap: \"1st\" + x4 <= 2\n";
    static const char *const name[][5] = {{"x1_", "x1", "end", "x4_", "x4"},
                                          {"x1_", "x1", "x3", "x4_", "x4"}};
    fmb_system *s = parse(FMB_FORMAT_TEXT, text, strlen(text));
    for (int i = 0; i < 2; i++) {
        fmb_format f = i == 0 ? FMB_FORMAT_MPS : FMB_FORMAT_LP;
        char *written = write_text(s, f);
        fmb_system *back = parse(f, written, strlen(written));
        for (int j = 0; j < 5; j++)
            cr_expect_str_eq(fmb_system_name(back, j), name[i][j], "%s", written);
        cr_expect_str_eq(fmb_system_label(back, 0), "r1");
        cr_expect_str_eq(fmb_system_label(back, 1), "cap");
        cr_expect_str_eq(fmb_system_label(back, 2), "r3");
        free(written);
        fmb_system_free(back);
    }
    fmb_system_free(s);
}

/* ---- what it costs --------------------------------------------------------------------------- */

static size_t blocks; /* of limbs that GMP has asked for */

static void *count_new_limbs(size_t bytes)
{
    blocks++;
    return malloc(bytes);
}

static void *count_grown_limbs(void *p, size_t old_bytes, size_t new_bytes)
{
    (void)old_bytes;
    blocks++;
    return realloc(p, new_bytes);
}

static void free_limbs(void *p, size_t bytes)
{
    (void)bytes;
    free(p);
}

/* How often GMP asks for memory while n rows of n terms are written. */
static size_t count_blocks_of_square(int n, fmb_format f)
{
    fmb_system *s = NULL;
    int64_t *row = calloc((size_t)n, sizeof *row);
    cr_assert(row && fmb_system_new(n, NULL, &s) == FMB_OK);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++)
            row[j] = 1 + (i + 7 * j) % 89;
        cr_assert_eq(fmb_system_add_int(s, row, FMB_LE, i), FMB_OK);
    }
    blocks = 0;
    mp_set_memory_functions(count_new_limbs, count_grown_limbs, free_limbs);
    free(write_text(s, f));
    mp_set_memory_functions(NULL, NULL, NULL);
    fmb_system_free(s);
    free(row);
    return blocks;
}

/* Four times as many rows, each four times as long, are sixteen times as many terms, and as much
 * work; what is done for each term about its whole row would make that sixty-four. */
Test(round, cost_of_dense_rows)
{
    static const fmb_format formats[] = {FMB_FORMAT_TEXT, FMB_FORMAT_INE, FMB_FORMAT_SMT2,
                                         FMB_FORMAT_MPS, FMB_FORMAT_LP};
    for (size_t k = 0; k < sizeof formats / sizeof *formats; k++) {
        size_t small = count_blocks_of_square(20, formats[k]);
        size_t large = count_blocks_of_square(80, formats[k]);
        cr_expect(large <= 20 * (small + 1), "%s: %zu, %zu", fmb_format_text(formats[k]), small,
                  large);
    }
}
