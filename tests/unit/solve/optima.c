/* optima.c: the optimum of a linear form: known optima, wrong arguments, and the use of a system's
 * own objective. Random ones are in tests/property/random. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/fmb.h>

#include "counted_clock.h"
#include "property/random/agree.h"
#include "support.h"

static fmb_solver *solver_of(fmb_method method, fmb_evidence_kept evidence)
{
    return must_open((fmb_options){.method = method, .evidence = evidence});
}

/* [give] .fmb text, its objective included. */
static fmb_system *system_of(const char *text)
{
    fmb_system *s = NULL;
    fmb_where w = {0};
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_TEXT};
    cr_assert_eq(fmb_system_parse(text, strlen(text), &how, &s, &w), FMB_OK, "%s", w.text);
    return s;
}

/* Evidence is accepted, and what the objective demands. */
static void expect_proved(fmb_solver *v, const fmb_system *s, fmb_verdict verdict)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    bool meets = false;
    char why[160] = "";
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    must(fmb_evidence_meets(e, s, FMB_DEMAND_OPTIMUM, NULL, &meets, why, sizeof why));
    cr_expect(j.accepted && j.verdict == verdict && meets, "%s%s", j.reason, why);
    fmb_evidence_free(e);
}

/* ---- known ones ------------------------------------------------------------------------------ */

#define BOX "0 <= x <= 5/2\n0 <= y\nx + y <= 4\n"

static const struct known {
    const char *text;
    fmb_end_kind kind;
    bool attained;
    const char *value, *point, *ray; /* coordinates by blanks */
} KNOWN[] = {
    {"vars: x y\nmax: 2x + y\n" BOX, FMB_END_FINITE, true, "13/2", "5/2 3/2", ""},
    {"vars: x y\nmin: 2x + y - 1/3\n" BOX, FMB_END_FINITE, true, "-1/3", "0 0", ""},
    {"vars: x y\nmax: 7\n" BOX, FMB_END_FINITE, true, "7", NULL, ""},
    {"vars: x y\nmin: x - y + 4\n" BOX, FMB_END_FINITE, true, "0", "0 4", ""},
    {"vars: x\nmax: 3x\nx < 2\n", FMB_END_FINITE, false, "6", "2", ""},
    {"vars: x y\nmax: x + y\nx < 2\ny <= 1\n", FMB_END_FINITE, false, "3", "2 1", ""},
    {"vars: x y\nmax: x\nx <= 2\ny < 1\n", FMB_END_FINITE, true, "2", NULL, ""},
    {"vars: x y\nmax: x - y\nx + y = 3\nx - 2y = 0\n", FMB_END_FINITE, true, "1", "2 1", ""},
    {"vars: x y\nmin: x + y\nx <= 4\n0 <= y <= 1\n", FMB_END_INFINITE, false, "", NULL, "-1 0"},
    {"vars: x y\nmax: x - 2y\nx <= 4\n", FMB_END_INFINITE, false, "", NULL, "0 -1"},
    {"vars: x y\nmax: x + y\nx - y = 1\n", FMB_END_INFINITE, false, "", NULL, ""},
    {"vars: x\nmin: x\n", FMB_END_INFINITE, false, "", "0", "-1"},
    {"vars: x\nmin: 0\n", FMB_END_FINITE, true, "0", "0", ""},
    {"0 <= 1\nmax: 5/2\n", FMB_END_FINITE, true, "5/2", "", ""},
    /* parts: x, y and u, v; w is in no row and not in the form */
    {"vars: x y u v w\nmax: x + 2u - v + 1\nx <= y\ny <= 3\nu + v < 4\nv >= 1\n", FMB_END_FINITE,
     false, "9", "3 3 3 1 0", ""},
    {"vars: x y u v\nmax: x + u\nx <= y\ny <= 3\nu <= v\n", FMB_END_INFINITE, false, "", NULL,
     "0 0 1 1"},
};

/* "1/2 0 3" for the coordinates of a point or ray, from 0 on. */
static void expect_coordinates(const fmb_optimum *o, int dim, bool ray, const char *expected,
                               const char *what)
{
    char said[256] = "";
    mpq_t q;
    mpq_init(q);
    for (int j = 0; expected && *expected && j < dim; j++) {
        size_t used = strlen(said);
        if (ray)
            fmb_optimum_ray_q(o, j, q);
        else
            fmb_optimum_coordinate_q(o, j, q);
        gmp_snprintf(said + used, sizeof said - used, j > 0 ? " %Qd" : "%Qd", q);
        cr_expect_eq(ray ? fmb_optimum_ray(o, j) : fmb_optimum_coordinate(o, j), mpq_get_d(q));
    }
    if (expected && *expected)
        cr_expect_str_eq(said, expected, "%s: %s", what, said);
    mpq_clear(q);
}

static void expect_known(const struct known *k, fmb_solver *v, bool proved)
{
    fmb_system *s = system_of(k->text);
    fmb_optimum *o = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_optimize(v, s, NULL, &o, &r));
    cr_assert(r.verdict == FMB_FEASIBLE && r.stop == FMB_STOP_DONE && o, "%s", k->text);
    fmb_end end = fmb_optimum_end(o);
    mpq_t q, expected;
    mpq_inits(q, expected, NULL);
    cr_expect(end.kind == k->kind && end.attained == k->attained, "%s", k->text);
    cr_expect_eq(fmb_optimum_sense(o), fmb_system_sense(s));
    if (k->kind == FMB_END_FINITE) {
        mpq_set_str(expected, k->value, 10);
        cr_expect(fmb_optimum_value_q(o, q) && mpq_equal(q, expected), "%s: about %g", k->text,
                  mpq_get_d(q));
    } else {
        cr_expect(!fmb_optimum_value_q(o, q) && isinf(end.value));
    }
    int dim = fmb_system_dim(s);
    expect_coordinates(o, dim, false, k->point, k->text);
    expect_coordinates(o, dim, true, k->ray, k->text);
    if (proved)
        expect_proved(v, s, FMB_FEASIBLE);
    mpq_clears(q, expected, NULL);
    fmb_optimum_free(o);
    fmb_system_free(s);
}

static const fmb_method METHODS[] = {FMB_METHOD_AUTO, FMB_METHOD_FM, FMB_METHOD_LP};

/* With evidence and without, by every method: the same. */
Test(optima, known)
{
    for (size_t m = 0; m < 3; m++)
        for (int kept = FMB_EVIDENCE_NONE; kept <= FMB_EVIDENCE_VERDICT; kept++) {
            fmb_solver *v = solver_of(METHODS[m], (fmb_evidence_kept)kept);
            for (size_t i = 0; i < sizeof KNOWN / sizeof *KNOWN; i++)
                expect_known(&KNOWN[i], v, kept == FMB_EVIDENCE_ALL);
            fmb_solver_free(v);
        }
}

Test(optima, infeasible)
{
    static const char *const texts[] = {"vars: x y\nmax: x\nx <= 1\nx >= 2\n",
                                        "vars: x y\nmin: y\nx < 1\nx > 1\n",
                                        "vars: x\nmax: x\n0 <= -1\n"};
    for (size_t m = 0; m < 3; m++)
        for (size_t i = 0; i < 3; i++) {
            fmb_solver *v = solver_of(METHODS[m], FMB_EVIDENCE_ALL);
            fmb_system *s = system_of(texts[i]);
            fmb_optimum *o = (fmb_optimum *)s;
            fmb_result r = {.size = sizeof r};
            must(fmb_optimize(v, s, NULL, &o, &r));
            cr_expect(r.verdict == FMB_INFEASIBLE && o == NULL);
            expect_proved(v, s, FMB_INFEASIBLE);
            fmb_system_free(s);
            fmb_solver_free(v);
        }
}

/* Doubles lie on the outer side, nearest to the exact value. */
Test(optima, doubles_are_rounded_outward)
{
    for (int sense = FMB_SENSE_MAX; sense <= FMB_SENSE_MIN; sense++) {
        fmb_solver *v = solver_of(FMB_METHOD_AUTO, FMB_EVIDENCE_NONE);
        fmb_system *s = system_of("-1/3 <= x <= 1/3");
        fmb_optimum *o = NULL;
        fmb_objective form = {(fmb_sense)sense, (double[]){1}, 0};
        must(fmb_optimize(v, s, &form, &o, NULL));
        double third = nextafter(1.0 / 3, 1), value = fmb_optimum_end(o).value;
        cr_expect_eq(value, sense == FMB_SENSE_MAX ? third : -third, "%a", value);
        fmb_optimum_free(o);
        fmb_system_free(s);
        fmb_solver_free(v);
    }
}

/* The form of the call counts, not that of the system; terms that come twice are added up. */
Test(optima, forms_of_the_call)
{
    fmb_solver *v = solver_of(FMB_METHOD_AUTO, FMB_EVIDENCE_ALL);
    fmb_system *s = system_of("vars: x y\nmax: x\n" BOX);
    fmb_optimum *o = NULL;
    fmb_result r = {.size = sizeof r};
    mpq_t coef[3], value;
    mpq_inits(coef[0], coef[1], coef[2], value, NULL);
    mpq_set_si(coef[0], 1, 1);
    mpq_set_si(coef[1], -1, 3);
    mpz_set_si(mpq_numref(coef[2]), 4); /* 4/2 */
    mpz_set_si(mpq_denref(coef[2]), 2);
    fmb_objective_q form = {FMB_SENSE_MAX, 3, (int[]){1, 0, 1}, coef, NULL};
    must(fmb_optimize_q(v, s, &form, &o, &r));
    cr_expect(fmb_optimum_value_q(o, value) && mpq_cmp_si(value, 12, 1) == 0);
    cr_expect_eq(mpz_cmp_si(mpq_numref(coef[2]), 4), 0, "only read");
    fmb_optimum_free(o);
    must(fmb_optimize_q(v, s, NULL, &o, &r));
    cr_expect(fmb_optimum_value_q(o, value) && mpq_cmp_si(value, 5, 2) == 0);
    fmb_optimum_free(o);
    mpq_clears(coef[0], coef[1], coef[2], value, NULL);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* ---- wrong arguments ------------------------------------------------------------------------- */

Test(optima, arguments)
{
    fmb_solver *v = solver_of(FMB_METHOD_AUTO, FMB_EVIDENCE_ALL);
    fmb_system *s = system_of("vars: x y\n" BOX);
    fmb_optimum *const mark = (fmb_optimum *)s, *o = mark;
    fmb_result r = {.size = sizeof r};
    mpq_t q[1], zero;
    mpq_inits(q[0], zero, NULL);
    mpz_set_ui(mpq_denref(zero), 0);
    const struct {
        fmb_objective o;
        const char *why;
    } bad[] = {{{FMB_SENSE_NONE, (double[]){1, 1}, 0}, "objective->sense is neither"},
               {{FMB_SENSE_MAX, NULL, 0}, "objective->coef is NULL"},
               {{FMB_SENSE_MAX, (double[]){1, NAN}, 0}, "objective->coef[1] is nan"},
               {{FMB_SENSE_MIN, (double[]){1, 1}, -INFINITY}, "objective->constant is -inf"}};
    const struct {
        fmb_objective_q o;
        const char *why;
    } bad_q[] = {{{FMB_SENSE_NONE, 0, NULL, NULL, NULL}, "objective->sense is neither"},
                 {{FMB_SENSE_MAX, 1, NULL, q, NULL}, "objective->var is NULL"},
                 {{FMB_SENSE_MAX, 1, (int[]){0}, NULL, NULL}, "objective->coef is NULL"},
                 {{FMB_SENSE_MAX, 1, (int[]){2}, q, NULL}, "objective->var[0] is 2, but"},
                 {{FMB_SENSE_MAX, 0, NULL, NULL, zero}, "objective->constant has denominator 0"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        cr_expect_eq(fmb_optimize(v, s, &bad[i].o, &o, &r), FMB_ERR_ARG);
        cr_expect(strstr(fmb_solver_trouble(v), bad[i].why), "%s", fmb_solver_trouble(v));
    }
    for (size_t i = 0; i < sizeof bad_q / sizeof *bad_q; i++) {
        cr_expect_eq(fmb_optimize_q(v, s, &bad_q[i].o, &o, &r), FMB_ERR_ARG);
        cr_expect(strstr(fmb_solver_trouble(v), bad_q[i].why), "%s", fmb_solver_trouble(v));
    }
    cr_expect_eq(fmb_optimize(v, s, NULL, &o, &r), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "objective is NULL, and the system has no objective");
    cr_expect_eq(fmb_optimize(v, s, &bad[0].o, NULL, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_optimize(NULL, s, &bad[0].o, &o, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_optimize(v, NULL, &bad[0].o, &o, &r), FMB_ERR_ARG);
    cr_expect_eq(o, mark);
    mpz_set_ui(mpq_denref(zero), 1);
    mpq_clears(q[0], zero, NULL);
    fmb_system_free(s);
    fmb_solver_free(v);
}

Test(optima, accessors_of_nothing)
{
    fmb_solver *v = solver_of(FMB_METHOD_AUTO, FMB_EVIDENCE_NONE);
    fmb_system *s = system_of("vars: x\nmax: x\nx <= 3\n");
    fmb_optimum *o = NULL;
    mpq_t q;
    mpq_init(q);
    must(fmb_optimize(v, s, NULL, &o, NULL));
    for (int j = -1; j <= 1; j += 2) {
        mpq_set_ui(q, 7, 1);
        fmb_optimum_coordinate_q(o, j, q);
        cr_expect_eq(mpq_sgn(q), 0);
        cr_expect(fmb_optimum_coordinate(o, j) == 0 && fmb_optimum_ray(o, j) == 0);
    }
    fmb_optimum_coordinate_q(o, 0, NULL);
    cr_expect_not(fmb_optimum_value_q(o, NULL));
    fmb_optimum_free(o);
    fmb_optimum_free(NULL);
    mpq_set_ui(q, 7, 1);
    cr_expect_eq(fmb_optimum_sense(NULL), FMB_SENSE_NONE);
    cr_expect_eq(fmb_optimum_end(NULL).kind, FMB_END_UNKNOWN);
    cr_expect_not(fmb_optimum_value_q(NULL, q));
    fmb_optimum_ray_q(NULL, 0, q);
    cr_expect(mpq_sgn(q) == 0 && fmb_optimum_ray(NULL, 0) == 0);
    mpq_clear(q);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* ---- the objective of a system --------------------------------------------------------------- */

/* A projection on all variables of the objective keeps it, and so does a reduced system. */
Test(optima, answers_keep_the_objective)
{
    fmb_solver *v = solver_of(FMB_METHOD_AUTO, FMB_EVIDENCE_NONE);
    fmb_system *s =
        system_of("vars: x y z\nmax: x - z/2 + 1\n0 <= x <= y\ny <= z\nz <= 4\nx <= 9\n");
    fmb_system *out = NULL;
    fmb_optimum *o = NULL;
    mpq_t q;
    mpq_init(q);
    must(fmb_project(v, s, (int[]){0, 2}, 2, &out, NULL));
    cr_expect_eq(fmb_system_objective_terms(out), 2);
    cr_expect(fmb_system_objective_term_q(out, 1, q) == 1 && mpq_cmp_si(q, -1, 2) == 0);
    must(fmb_optimize(v, out, NULL, &o, NULL));
    cr_expect(fmb_optimum_value_q(o, q) && mpq_cmp_si(q, 3, 1) == 0);
    fmb_optimum_free(o);
    fmb_system_free(out);
    must(fmb_project(v, s, (int[]){0, 1}, 2, &out, NULL));
    cr_expect_eq(fmb_system_sense(out), FMB_SENSE_NONE);
    fmb_system_free(out);
    must(fmb_reduce(v, s, NULL, &out, NULL));
    cr_expect_eq(fmb_system_sense(out), FMB_SENSE_MAX);
    cr_expect_eq(fmb_system_objective_terms(out), 2);
    fmb_system_free(out);
    mpq_clear(q);
    fmb_system_free(s);
    fmb_solver_free(v);
}
