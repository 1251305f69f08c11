/* claims.c: fmb_check on right and wrong evidence of every kind. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "naive.h"
#include "samples.h"

static void judge(const proof_sample *p)
{
    fmb_judgement j = {.size = sizeof j};
    fmb_system *s = proof_system(p->system, NULL);
    fmb_evidence *e = proof_claims(s, p->claims);
    cr_assert_eq(fmb_check(s, e, &j), FMB_OK);
    cr_expect_eq(j.accepted, p->why == NULL, "%s: %s", p->name, j.reason);
    cr_expect_not_null(strstr(j.reason, p->why ? p->why : ""), "%s: %s", p->name, j.reason);
    if (!p->why)
        cr_expect_eq(j.verdict, p->verdict, "%s: %s", p->name, fmb_verdict_text(j.verdict));
    if (fmb_evidence_claims(e) > 0)
        cr_expect_eq(j.accepted, j.claim == SIZE_MAX, "%s", p->name);
    cr_expect_eq(naive_first_failing(s, e), j.claim, "%s: the naive judge disagrees", p->name);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

Test(claims, samples)
{
    for (size_t i = 0; i < proof_samples_count; i++)
        judge(&proof_samples[i]);
}

/* The table has something right and something wrong of every kind. */
Test(claims, every_kind)
{
    for (fmb_claim_kind kind = FMB_CLAIM_FEASIBLE; kind <= FMB_CLAIM_FOLLOWS; kind++) {
        int right = 0, wrong = 0;
        for (size_t i = 0; i < proof_samples_count; i++) {
            const proof_sample *p = &proof_samples[i];
            fmb_system *s = proof_system(p->system, NULL);
            fmb_evidence *e = proof_claims(s, p->claims);
            for (size_t k = 0; k < fmb_evidence_claims(e); k++) {
                right += fmb_evidence_kind(e, k) == kind && !p->why;
                wrong += fmb_evidence_kind(e, k) == kind && p->why;
            }
            fmb_evidence_free(e);
            fmb_system_free(s);
        }
        cr_expect_geq(right, 2, "kind %d", kind);
        cr_expect_geq(wrong, 3, "kind %d", kind);
    }
}

/* Evidence made for another shape of system is the caller's error. */
Test(claims, other_shape)
{
    fmb_judgement j = {.size = sizeof j, .claim = 77};
    fmb_system *s = proof_system("x\n1 <= 1", NULL), *two = proof_system("x\n1 <= 1\n1 <= 2", NULL),
               *wide = proof_system("x y\n1 0 <= 1", NULL);
    fmb_evidence *e = proof_claims(s, "claim feasible\npoint x 0\nend\n");
    cr_expect_eq(fmb_check(two, e, &j), FMB_ERR_ARG);
    cr_expect_eq(fmb_check(wide, e, &j), FMB_ERR_ARG);
    cr_expect_eq(j.claim, 77);
    cr_expect_eq(fmb_evidence_write(e, two, stderr), FMB_ERR_ARG);
    fmb_evidence_free(e);
    fmb_system_free(s);
    fmb_system_free(two);
    fmb_system_free(wide);
}

/* What no reader lets through, but a caller inside the library might get wrong. */
Test(claims, malformed)
{
    fmb_system *s = proof_system("x\n1 <= 1", NULL);
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    for (int kind = -1; kind <= FMB_CLAIM_FOLLOWS + 1; kind++)
        for (int part = 0; part < 6; part++) {
            fmb_evidence *e = NULL;
            fmb_claim *c = NULL;
            fmb_judgement j = {.size = sizeof j};
            cr_assert_eq(fmb_evidence_new(1, 1, NULL, &e), FMB_OK);
            cr_assert_eq(fmb_evidence_claim(e, (fmb_claim_kind)kind, &c), FMB_OK);
            if (part == 1)
                cr_assert_eq(fmb_evidence_push(e, &c->multipliers, 1, one), FMB_OK);
            if (part == 2)
                cr_assert_eq(fmb_evidence_push(e, &c->terms, 1, one), FMB_OK);
            if (part == 3)
                c->row = 1;
            if (part == 4)
                c->var = 1;
            if (part == 5) {
                cr_assert_eq(fmb_evidence_push(e, &c->point, 1, one), FMB_OK);
                cr_assert_eq(fmb_evidence_push(e, &c->ray, 1, one), FMB_OK);
            }
            cr_assert_eq(fmb_check(s, e, &j), FMB_OK);
            bool origin = (kind == FMB_CLAIM_FEASIBLE || kind == FMB_CLAIM_CORNER) &&
                          part != 5; /* a point without coordinates */
            bool names_nothing = part == 0 || part == 3;
            bool empty_but_true = origin ||
                                  ((kind == FMB_CLAIM_IMPLIED || kind == FMB_CLAIM_FOLLOWS) &&
                                   (names_nothing || part == 5)) ||
                                  (kind == FMB_CLAIM_BOUND && names_nothing); /* 0 >= 0 */
            cr_expect_eq(j.accepted, empty_but_true, "kind %d, part %d", kind, part);
            cr_expect_eq(naive_first_failing(s, e), j.claim, "kind %d, part %d", kind, part);
            fmb_evidence_free(e);
        }
    mpq_clear(one);
    fmb_system_free(s);
}

/* No variables: only right sides matter. */
Test(claims, no_variables)
{
    fmb_system *s = NULL;
    fmb_judgement j = {.size = sizeof j};
    int64_t none = 0;
    cr_assert_eq(fmb_system_new(0, NULL, &s), FMB_OK);
    cr_assert_eq(fmb_system_add_int(s, &none, FMB_LE, 2), FMB_OK);
    fmb_evidence *e = proof_claims(s, "claim feasible\nend\n");
    cr_expect_eq(fmb_check(s, e, &j), FMB_OK);
    cr_expect(j.accepted && j.verdict == FMB_FEASIBLE);
    fmb_evidence_free(e);
    cr_assert_eq(fmb_system_add_int(s, &none, FMB_LT, 0), FMB_OK);
    e = proof_claims(s, "claim infeasible\nrow 2 1\nend\n");
    cr_expect_eq(fmb_check(s, e, &j), FMB_OK);
    cr_expect(j.accepted && j.verdict == FMB_INFEASIBLE);
    fmb_evidence_free(e);
    e = proof_claims(s, "claim feasible\nend\n");
    cr_expect_eq(fmb_check(s, e, &j), FMB_OK);
    cr_expect(!j.accepted && j.verdict == FMB_UNKNOWN);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

Test(claims, accessors)
{
    fmb_system *s = proof_system("x y\n1 1 <= 4\n-1 0 <= 0\n0 -1 <= 0\n2 0 <= 5", NULL);
    fmb_evidence *e = proof_claims(
        s, "claim bound upper x <= 5/2\nrow 4 1/3\npoint x 1/3\npoint y 9007199254740993\nend\n"
           "claim unbounded lower y\nray x 0\nray y -1/2\nend\nclaim redundant 3\nend\n");
    mpq_t q;
    mpq_init(q);
    cr_expect_eq(fmb_evidence_claims(e), 3);
    cr_expect_eq(fmb_evidence_kind(e, 1), FMB_CLAIM_UNBOUNDED);
    cr_expect_eq(fmb_evidence_var(e, 1), 1);
    cr_expect_eq(fmb_evidence_var(e, 2), -1);
    cr_expect_eq(fmb_evidence_row(e, 2), 2);
    cr_expect_eq(fmb_evidence_row(e, 0), SIZE_MAX);
    cr_expect_eq(fmb_evidence_multiplier(e, 0, 3), 1.0 / 3);
    cr_expect_eq(fmb_evidence_multiplier(e, 0, 0), 0);
    cr_expect_eq(fmb_evidence_next_row(e, 0, 0), 3);
    cr_expect_eq(fmb_evidence_next_row(e, 0, 3), 3);
    cr_expect_eq(fmb_evidence_next_row(e, 0, 4), SIZE_MAX);
    cr_expect_eq(fmb_evidence_coordinate(e, 0, 0), 1.0 / 3);
    cr_expect_eq(fmb_evidence_coordinate(e, 0, 1), 9007199254740992.0);
    cr_expect_eq(fmb_evidence_coordinate(e, 1, 1), 0);
    fmb_evidence_value_q(e, 0, q);
    cr_expect_eq(mpq_cmp_si(q, 5, 2), 0);
    fmb_evidence_ray_q(e, 1, 1, q);
    cr_expect_eq(mpq_cmp_si(q, -1, 2), 0);
    fmb_evidence_ray_q(e, 0, 1, q);
    cr_expect_eq(mpq_sgn(q), 0);
    fmb_evidence_multiplier_q(e, 0, 3, q);
    cr_expect_eq(mpq_cmp_si(q, 1, 3), 0);
    fmb_evidence_coordinate_q(e, 0, 0, q);
    cr_expect_eq(mpq_cmp_si(q, 1, 3), 0);
    mpq_clear(q);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

/* 2/3 is nearer to the double above what cutting gives. */
Test(claims, nearest_double)
{
    fmb_system *s = proof_system("x y\n1 1 <= 9", NULL);
    fmb_evidence *e = proof_claims(s, "claim feasible\npoint x 2/3\npoint y -2/3\nend\n");
    cr_expect_eq(fmb_evidence_coordinate(e, 0, 0), 2.0 / 3);
    cr_expect_eq(fmb_evidence_coordinate(e, 0, 1), -2.0 / 3);
    fmb_evidence_free(e);
    fmb_system_free(s);
}
