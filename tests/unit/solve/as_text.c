/* as_text.c: every rational of an answer is available as text and as the nearest double, too. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>

#include "support/must.h"

/* x from -2/7 to 1/3, y from x on. */
static fmb_system *open_strip(void)
{
    static const char text[] = "vars: x y\n3x <= 1\n7x >= -2\ny >= x\n";
    fmb_system *s = NULL;
    must(fmb_system_parse(text, sizeof text - 1, NULL, &s, NULL));
    return s;
}

static fmb_solver *open_solver(void)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

/* Numerators and denominators are short, so their quotient is the nearest double. */
static void expect_number(const char *what, mpq_srcptr q, double x, const char *text, size_t length)
{
    char *want = mpq_get_str(NULL, 10, q);
    cr_expect_str_eq(text, want, "%s: %s, not %s", what, text, want);
    cr_expect_eq(length, strlen(want), "%s", what);
    cr_expect_eq(x, mpz_get_d(mpq_numref(q)) / mpz_get_d(mpq_denref(q)), "%s: %a", what, x);
    free(want);
}

/* ---- boxes ----------------------------------------------------------------------------------- */

Test(as_text, boxes)
{
    fmb_system *s = open_strip();
    fmb_solver *v = open_solver();
    fmb_box *b = NULL;
    double lower[2], upper[2];
    char text[16];
    mpq_t q;
    mpq_init(q);
    must(fmb_bound(v, s, NULL, 0, &b, NULL));
    must(fmb_box_ends(b, lower, upper));
    for (int i = 0; i < 2; i++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
            cr_expect_eq(side ? upper[i] : lower[i], fmb_box_end(b, i, (fmb_side)side).value);
            if (!fmb_box_end_q(b, i, (fmb_side)side, q))
                continue;
            size_t length = fmb_box_end_text(b, i, (fmb_side)side, text, sizeof text);
            expect_number("end", q, fmb_box_nearest(b, i, (fmb_side)side), text, length);
        }
    cr_expect(upper[0] > 1.0 / 3 && fmb_box_nearest(b, 0, FMB_UPPER) == 1.0 / 3,
              "ends lie outside, the nearest doubles need not");
    cr_expect_eq(fmb_box_end_text(b, 1, FMB_UPPER, text, sizeof text), 0);
    cr_expect_str_empty(text);
    cr_expect_eq(fmb_box_nearest(b, 1, FMB_UPPER), INFINITY);
    cr_expect_eq(fmb_box_end_text(NULL, 0, FMB_UPPER, NULL, 0), 0);
    cr_expect_eq(fmb_box_end_text(b, 2, FMB_UPPER, text, sizeof text), 0);
    cr_expect_eq(fmb_box_nearest(b, 0, (fmb_side)7), 0);
    cr_expect_eq(fmb_box_ends(NULL, lower, upper), FMB_ERR_ARG);
    must(fmb_box_ends(b, NULL, NULL));
    mpq_clear(q);
    fmb_box_free(b);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* ---- optima ---------------------------------------------------------------------------------- */

static void expect_optimum(fmb_solver *v, fmb_system *s, fmb_sense sense, const char *value,
                           double nearest)
{
    fmb_objective o = {sense, (double[]){1, 1}, 0};
    fmb_optimum *found = NULL;
    char text[16];
    mpq_t q;
    mpq_init(q);
    must(fmb_optimize(v, s, &o, &found, NULL));
    cr_expect_eq(fmb_optimum_value_text(found, text, sizeof text), strlen(value));
    cr_expect_str_eq(text, value);
    cr_expect_eq(fmb_optimum_nearest(found), nearest);
    for (int j = 0; j < 3; j++) { /* the third is none: 0 */
        fmb_optimum_coordinate_q(found, j, q);
        size_t length = fmb_optimum_coordinate_text(found, j, text, sizeof text);
        expect_number("coordinate", q, fmb_optimum_coordinate(found, j), text, length);
        fmb_optimum_ray_q(found, j, q);
        length = fmb_optimum_ray_text(found, j, text, sizeof text);
        expect_number("ray", q, fmb_optimum_ray(found, j), text, length);
    }
    mpq_clear(q);
    fmb_optimum_free(found);
}

Test(as_text, optima)
{
    fmb_system *s = open_strip();
    fmb_solver *v = open_solver();
    char text[] = "?";
    expect_optimum(v, s, FMB_SENSE_MIN, "-4/7", -4.0 / 7);
    expect_optimum(v, s, FMB_SENSE_MAX, "", INFINITY);
    cr_expect_eq(fmb_optimum_value_text(NULL, text, sizeof text), 0);
    cr_expect_str_empty(text);
    cr_expect_eq(fmb_optimum_nearest(NULL), 0);
    cr_expect_eq(fmb_optimum_coordinate_text(NULL, 0, NULL, 0), 1);
    cr_expect_eq(fmb_optimum_ray_text(NULL, 0, text, sizeof text), 1);
    cr_expect_str_eq(text, "0");
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* ---- generators ------------------------------------------------------------------------------ */

Test(as_text, generators)
{
    fmb_system *s = open_strip();
    fmb_solver *v = open_solver();
    fmb_generators *g = NULL;
    double x[3][2];
    fmb_generator_kind kind[3];
    char text[16];
    mpq_t q;
    mpq_init(q);
    must(fmb_generate(v, s, &g, NULL));
    cr_assert_eq(fmb_generators_size(g), 3);
    must(fmb_generators_get(g, 0, 3, kind, x[0]));
    for (size_t i = 0; i < 3; i++) {
        cr_expect_eq(kind[i], fmb_generators_kind(g, i));
        for (int j = 0; j < 2; j++) {
            fmb_generators_coordinate_q(g, i, j, q);
            size_t length = fmb_generators_coordinate_text(g, i, j, text, sizeof text);
            expect_number("coordinate", q, x[i][j], text, length);
        }
    }
    must(fmb_generators_get(g, 2, 1, kind, NULL));
    cr_expect_eq(kind[0], fmb_generators_kind(g, 2));
    must(fmb_generators_get(g, 3, 0, NULL, NULL));
    cr_expect_eq(fmb_generators_get(g, 3, 1, kind, x[0]), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_get(g, 1, SIZE_MAX, kind, x[0]), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_get(NULL, 0, 0, kind, x[0]), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_coordinate_text(NULL, 0, 0, text, sizeof text), 1);
    cr_expect_str_eq(text, "0");
    mpq_clear(q);
    fmb_generators_free(g);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* ---- evidence -------------------------------------------------------------------------------- */

/* Of a claim, also of the one behind the last: everything is 0. */
static void expect_claim(const fmb_evidence *e, size_t i, mpq_t q)
{
    char text[32];
    for (int j = -1; j < 3; j++) {
        fmb_evidence_coordinate_q(e, i, j, q);
        size_t length = fmb_evidence_coordinate_text(e, i, j, text, sizeof text);
        expect_number("coordinate", q, fmb_evidence_coordinate(e, i, j), text, length);
        fmb_evidence_ray_q(e, i, j, q);
        length = fmb_evidence_ray_text(e, i, j, text, sizeof text);
        expect_number("ray", q, fmb_evidence_ray(e, i, j), text, length);
    }
    for (size_t r = 0; r < 4; r++) {
        fmb_evidence_multiplier_q(e, i, r, q);
        size_t length = fmb_evidence_multiplier_text(e, i, r, text, sizeof text);
        expect_number("multiplier", q, fmb_evidence_multiplier(e, i, r), text, length);
    }
    fmb_evidence_value_q(e, i, q);
    size_t length = fmb_evidence_value_text(e, i, text, sizeof text);
    expect_number("value", q, fmb_evidence_value(e, i), text, length);
    for (size_t k = 0; k <= fmb_evidence_terms(e, i); k++) {
        double coef = 7;
        cr_expect_eq(fmb_evidence_term_q(e, i, k, q), fmb_evidence_term(e, i, k, &coef));
        length = fmb_evidence_term_text(e, i, k, text, sizeof text);
        expect_number("term", q, coef, text, length);
    }
    cr_expect_eq(fmb_evidence_term(e, i, SIZE_MAX, NULL), -1);
}

/* Claims with every kind of number: a box has multipliers, points, values and a ray, an optimum
 * terms as well. */
Test(as_text, evidence)
{
    fmb_system *s = open_strip();
    fmb_solver *v = open_solver();
    fmb_box *b = NULL;
    fmb_optimum *best = NULL;
    fmb_objective o = {FMB_SENSE_MIN, (double[]){1, 0.5}, 0};
    mpq_t q;
    mpq_init(q);
    must(fmb_bound(v, s, NULL, 0, &b, NULL));
    for (int kind = 0; kind < 2; kind++) {
        fmb_evidence *e = NULL;
        size_t rays = 0, terms = 0;
        must(fmb_solver_evidence(v, &e));
        for (size_t i = 0; i <= fmb_evidence_claims(e); i++) {
            expect_claim(e, i, q);
            rays += fmb_evidence_ray(e, i, 1) > 0;
            terms += fmb_evidence_terms(e, i);
        }
        cr_expect(kind ? terms == 2 : rays == 1, "%zu rays, %zu terms", rays, terms);
        fmb_evidence_free(e);
        if (kind == 0)
            must(fmb_optimize(v, s, &o, &best, NULL));
    }
    expect_claim(NULL, 0, q);
    mpq_clear(q);
    fmb_optimum_free(best);
    fmb_box_free(b);
    fmb_solver_free(v);
    fmb_system_free(s);
}
