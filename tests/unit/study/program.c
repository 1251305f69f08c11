/* program.c: families of linear programs: the planted answers are true, and the same seed draws the
 * same program. */
#include <criterion/criterion.h>

#include <stdlib.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/gmp.h>

#include "study/program/program.h"
#include "support.h"

static study_program draw(int family, int rows, int variables, uint64_t seed)
{
    study_program_plan plan = {family, rows, variables, seed};
    study_program p;
    cr_assert_eq(study_program_draw(&plan, &p), FMB_OK);
    return p;
}

static int family_of(const char *name)
{
    study_program_plan plan;
    const char *bad;
    cr_assert(study_program_plan_parse(name, &plan, &bad), "%s: %s", name, bad);
    return plan.family;
}

static void judge_plan(int f, int rows, int variables, uint64_t seed)
{
    study_program p = draw(f, rows, variables, seed);
    cr_assert(p.verdict == FMB_UNKNOWN || support_proved_verdict(p.s) == p.verdict,
              "%s: %d rows, %d variables, seed %llu", study_program_name(f), rows, variables,
              (unsigned long long)seed);
    study_program_clear(&p);
}

Test(program, planted_verdicts_are_true)
{
    for (int f = 0; f < study_program_families(); f++)
        for (uint64_t seed = 0; seed < 6; seed++)
            judge_plan(f, 3 + 7 * (int)seed, 2 + 3 * (int)seed, seed);
}

Test(program, smallest_sizes)
{
    for (int f = 0; f < study_program_families(); f++)
        for (int rows = 1; rows <= 3; rows++)
            for (int n = 1; n <= 2; n++)
                judge_plan(f, rows, n, (uint64_t)rows);
}

static bool same_rows(const fmb_system *a, const fmb_system *b)
{
    char *text[2] = {NULL};
    size_t size[2];
    const fmb_system *s[2] = {a, b};
    for (int i = 0; i < 2; i++) {
        FILE *out = open_memstream(&text[i], &size[i]);
        cr_assert_eq(fmb_system_write(s[i], FMB_FORMAT_TEXT, out), FMB_OK);
        fclose(out);
    }
    bool same = strcmp(text[0], text[1]) == 0;
    free(text[0]);
    free(text[1]);
    return same;
}

Test(program, a_seed_is_a_program)
{
    int f = family_of("sparse-point");
    study_program a = draw(f, 20, 10, 7), b = draw(f, 20, 10, 7), c = draw(f, 20, 10, 8);
    cr_assert(same_rows(a.s, b.s));
    cr_assert_not(same_rows(a.s, c.s));
    study_program_clear(&a);
    study_program_clear(&b);
    study_program_clear(&c);
}

static bool best_of(const study_program *p, mpq_t best)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_optimum *optimum = NULL;
    fmb_result r = {.size = sizeof r};
    cr_assert_eq(fmb_solver_new(&o, NULL, &v), FMB_OK);
    cr_assert_eq(fmb_optimize(v, p->s, NULL, &optimum, &r), FMB_OK);
    bool finite = fmb_optimum_value_q(optimum, best);
    fmb_optimum_free(optimum);
    fmb_solver_free(v);
    return finite;
}

Test(program, known_best_values_are_true)
{
    static const char *const name[] = {"klee-minty", "beale", "kuhn", "cube", "chain"};
    mpq_t best;
    mpq_init(best);
    for (size_t i = 0; i < sizeof name / sizeof *name; i++)
        for (int n = 1; n <= 8; n++) {
            study_program p = draw(family_of(name[i]), 0, n, 1);
            cr_assert(p.has_best);
            cr_assert(best_of(&p, best));
            cr_assert(mpq_equal(best, p.best), "%s of %d", name[i], n);
            study_program_clear(&p);
        }
    study_program p = draw(family_of("unbounded"), 12, 5, 3);
    cr_assert_not(best_of(&p, best));
    study_program_clear(&p);
    mpq_clear(best);
}

Test(program, plans_are_read_and_written)
{
    study_program_plan plan = {.seed = 5};
    const char *bad = NULL;
    char text[64];
    cr_assert(study_program_plan_parse("sparse-origin:2000x100", &plan, &bad));
    cr_assert(plan.rows == 2000 && plan.variables == 100 && plan.seed == 5);
    study_program_plan_text(&plan, text, sizeof text);
    cr_assert_str_eq(text, "sparse-origin:2000x100");
    cr_assert(study_program_plan_parse("klee-minty:12", &plan, &bad));
    study_program_plan_text(&plan, text, sizeof text);
    cr_assert_str_eq(text, "klee-minty:12");
    static const char *const wrong[] = {
        "",       "sparse", "sparse-origins", "sparse-origin:7",   "klee-minty:3x4",
        "cube:0", "cube:",  "cube:7 ",        "sparse-origin:0x3", "cube:1000000"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        cr_assert_not(study_program_plan_parse(wrong[i], &plan, &bad), "%s", wrong[i]);
}

/* x = 10^power y: a row of the one is a power of ten times that of the other. */
Test(program, scales_keep_the_solutions)
{
    int power[12];
    mpq_t a, b, factor;
    mpq_inits(a, b, factor, NULL);
    study_program p = draw(family_of("strict"), 20, 12, 4);
    fmb_system *t = NULL;
    cr_assert_eq(study_system_rescale(p.s, 9, 4, power, &t), FMB_OK);
    bool any = false;
    for (size_t i = 0; i < 20; i++) {
        cr_assert_eq(fmb_system_rel(p.s, i), fmb_system_rel(t, i));
        fmb_system_rhs_q(p.s, i, a);
        fmb_system_rhs_q(t, i, b);
        if (mpq_sgn(a) == 0)
            continue;
        mpq_div(factor, b, a);
        any |= mpq_cmp_ui(factor, 1, 1) != 0;
        for (size_t k = 0; k < fmb_system_terms(p.s, i); k++) {
            int j = fmb_system_term_q(p.s, i, k, a);
            cr_assert_eq(j, fmb_system_term_q(t, i, k, b));
            mpq_mul(a, a, factor);
            for (int e = 0; e < abs(power[j]); e++) {
                mpz_ptr to = power[j] < 0 ? mpq_denref(a) : mpq_numref(a);
                mpz_mul_ui(to, to, 10);
            }
            mpq_canonicalize(a);
            cr_assert(mpq_equal(a, b));
        }
    }
    cr_assert(any);
    mpq_clears(a, b, factor, NULL);
    fmb_system_free(t);
    study_program_clear(&p);
}

Test(program, fractions_are_near_and_long)
{
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    study_program p = draw(family_of("equalities"), 20, 12, 4);
    fmb_system *t = NULL;
    size_t digits = 0;
    cr_assert_eq(study_system_fractions(p.s, 10, 4, &t), FMB_OK);
    for (size_t i = 0; i < 20; i++)
        for (size_t k = 0; k < fmb_system_terms(p.s, i); k++) {
            fmb_system_term_q(p.s, i, k, a);
            fmb_system_term_q(t, i, k, b);
            size_t n = mpz_sizeinbase(mpq_denref(b), 10); /* or one more */
            digits = n > digits ? n : digits;
            mpq_sub(b, b, a);
            cr_assert(mpq_get_d(b) < 1e-7 && mpq_get_d(b) > -1e-7);
        }
    cr_assert(digits == 10 || digits == 11);
    mpq_clears(a, b, NULL);
    fmb_system_free(t);
    study_program_clear(&p);
}
