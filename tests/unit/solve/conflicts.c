/* conflicts.c: the multipliers of a conflict are coprime integers, whichever engine found it. */
#include <criterion/criterion.h>

#include "property/random/options.h"
#include "property/random/rows.h"
#include "support.h"
#include "system/system_private.h"

/* How often a multiplier other than 1 or -1 was seen. */
static int expect_lowest_terms(fmb_solver *v, const fmb_system *s, const char *ways)
{
    fmb_evidence *e = NULL;
    int others = 0;
    mpq_t y;
    mpz_t common;
    mpq_init(y);
    mpz_init(common);
    must(fmb_solver_evidence(v, &e));
    cr_assert_eq(fmb_evidence_kind(e, 0), FMB_CLAIM_INFEASIBLE);
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        fmb_evidence_multiplier_q(e, 0, i, y);
        cr_expect_eq(mpz_cmp_ui(mpq_denref(y), 1), 0, "%s", ways);
        mpz_gcd(common, common, mpq_numref(y));
        others += mpq_sgn(y) != 0 && mpz_cmpabs_ui(mpq_numref(y), 1) != 0;
    }
    cr_expect_eq(mpz_cmp_ui(common, 1), 0, "%s", ways);
    fmb_evidence_free(e);
    mpz_clear(common);
    mpq_clear(y);
    return others;
}

static fmb_verdict ask(fmb_solver *v, const fmb_system *s, int question)
{
    fmb_result r = {.size = sizeof r};
    fmb_system *out = NULL;
    fmb_box *box = NULL;
    static const int none[1];
    if (question == 0)
        must(fmb_solve(v, s, &r));
    else if (question == 1)
        must(fmb_bound(v, s, NULL, 0, &box, &r));
    else if (question == 2)
        must(fmb_project(v, s, none, 0, &out, &r));
    else
        must(fmb_reduce(v, s, NULL, &out, &r));
    fmb_box_free(box);
    fmb_system_free(out);
    return r.verdict;
}

Test(conflicts, lowest_terms)
{
    int others = 0, infeasible = 0;
    for (int i = 0; i < options_count(); i += WATCHED) {
        char ways[200];
        fmb_options o = options_at(i);
        fmb_solver *v = NULL;
        options_text(&o, ways, sizeof ways);
        must(fmb_solver_new(&o, NULL, &v));
        for (uint64_t seed = 0; seed < 12; seed++) {
            support_case c = support_make(seed % 3 == 0 ? SUPPORT_MIXED : SUPPORT_PLANTED_FARKAS,
                                          1000 * (uint64_t)i + seed, NULL);
            for (int question = 0; question < 4; question++) {
                if (ask(v, c.s, question) != FMB_INFEASIBLE)
                    continue;
                infeasible++;
                others += expect_lowest_terms(v, c.s, ways);
            }
            support_case_clear(&c);
        }
        fmb_solver_free(v);
    }
    cr_expect(infeasible > 1000 / WATCHED && others > 1000 / WATCHED,
              "%d conflicts, %d multipliers", infeasible, others);
}

/* ---- irreducible ----------------------------------------------------------------------------- */

/* Rows of s that the conflict names, without the one of number `without` among them. */
static fmb_system *rows_of_conflict(const fmb_system *s, const fmb_evidence *e, size_t without)
{
    fmb_system *t = NULL;
    mpq_t y;
    mpq_init(y);
    must(fmb_system_copy(s, &t));
    for (size_t i = fmb_system_rows(s); i-- > 0;) {
        fmb_evidence_multiplier_q(e, 0, i, y);
        if (mpq_sgn(y) == 0 || i == without)
            fmb_system_remove(t, i);
    }
    mpq_clear(y);
    return t;
}

Test(conflicts, no_row_can_be_left_out)
{
    fmb_solver *v = NULL, *other = NULL;
    fmb_options lp = {.size = sizeof lp}, o = (fmb_options){.size = sizeof(fmb_options)};
    lp.method = FMB_METHOD_LP;
    o.rules = "duplicate,dominated,lp";
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solver_new(&lp, NULL, &other));
    for (uint64_t seed = 0; seed < 300; seed++) {
        support_case c = support_make(SUPPORT_PLANTED_FARKAS, seed, NULL);
        fmb_evidence *e = NULL;
        fmb_result r = {.size = sizeof r};
        must(fmb_solve(v, c.s, &r));
        cr_assert_eq(r.verdict, FMB_INFEASIBLE);
        must(fmb_solver_evidence(v, &e));
        for (size_t i = 0; i < fmb_system_rows(c.s); i++) {
            fmb_system *t = rows_of_conflict(c.s, e, i);
            mpq_t y;
            mpq_init(y);
            fmb_evidence_multiplier_q(e, 0, i, y);
            must(fmb_solve(other, t, &r));
            cr_expect_eq(r.verdict, mpq_sgn(y) == 0 ? FMB_INFEASIBLE : FMB_FEASIBLE, "seed %d",
                         (int)seed);
            mpq_clear(y);
            fmb_system_free(t);
        }
        fmb_evidence_free(e);
        support_case_clear(&c);
    }
    fmb_solver_free(v);
    fmb_solver_free(other);
}
