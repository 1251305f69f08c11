/* mutate.c: no mutation of right evidence is accepted wrongly.
 *
 * Proofs of the solver and of the table in samples.c are changed, a number, a name or a relation at
 * a time, in the evidence or in the system; then fmb_check must agree with the naive judge, and
 * never accept a verdict that the ground truth contradicts.
 */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/solve.h>

#include "mutations.h"
#include "naive.h"
#include "samples.h"
#include "study/textbook/exact.h"
#include "support/dense.h"
#include "support/must.h"

typedef struct tally {
    int judged, accepted;
    int by_kind[FMB_CLAIM_FOLLOWS + 1]; /* rejected for a claim of that kind */
} tally;

static void judge(const fmb_system *s, const fmb_evidence *e, const char *what, tally *t)
{
    fmb_judgement j = {.size = sizeof j};
    fmb_verdict truth = FMB_UNKNOWN;
    cr_assert_eq(fmb_check(s, e, &j), FMB_OK);
    size_t failing = naive_first_failing(s, e);
    if (j.claim != failing || j.accepted != (failing == SIZE_MAX && e->claims > 0)) {
        support_print(s, what, stderr);
        (void)!fmb_evidence_write(e, s, stderr);
        cr_assert_fail("%s: claim %zu fails (%s), but %zu for the naive judge", what, j.claim,
                       j.reason, failing);
    }
    if (j.verdict != FMB_UNKNOWN) {
        cr_assert_eq(study_textbook_solve(s, 5000, &truth), FMB_OK);
        cr_assert(truth == FMB_UNKNOWN || truth == j.verdict, "%s: proves what is not", what);
    }
    t->judged++;
    t->accepted += j.accepted;
    if (!j.accepted && failing < e->claims && e->claim[failing].kind <= FMB_CLAIM_FOLLOWS)
        t->by_kind[e->claim[failing].kind]++;
}

/* Change copies of s and e so many times, one to three changes each, and judge them. */
static void mutate(const fmb_system *s, const fmb_evidence *e, uint64_t seed, int times, tally *t)
{
    char what[64];
    subject u = {.g = {seed}};
    for (int k = 0; k < times; k++) {
        must(fmb_system_copy(s, &u.s));
        u.e = proof_copy(s, e);
        snprintf(what, sizeof what, "seed %llu, mutation %d", (unsigned long long)seed, k);
        int changes = 0, wanted = support_chance(&u.g, 80) ? 1 : support_between(&u.g, 2, 3);
        while (changes < wanted && u.e->claims > 0)
            changes += subject_change(&u);
        judge(u.s, u.e, what, t);
        fmb_evidence_free(u.e);
        fmb_system_free(u.s);
    }
}

/* ---- the tests ------------------------------------------------------------------------------- */

Test(mutate, samples)
{
    tally t = {0};
    for (size_t i = 0; i < proof_samples_count; i++) {
        fmb_system *s = proof_system(proof_samples[i].system, NULL);
        fmb_evidence *e = proof_claims(s, proof_samples[i].claims);
        if (fmb_evidence_claims(e) > 0)
            mutate(s, e, i, 60, &t);
        fmb_evidence_free(e);
        fmb_system_free(s);
    }
    cr_expect_geq(t.judged, 4000);
    cr_expect_geq(t.accepted, 200);
    for (fmb_claim_kind kind = FMB_CLAIM_FEASIBLE; kind <= FMB_CLAIM_FOLLOWS; kind++)
        cr_expect_geq(t.by_kind[kind], 50, "kind %d", kind);
}

/* Ask question number which; the evidence, or NULL. */
static fmb_evidence *ask(fmb_solver *v, const fmb_system *s, int which)
{
    fmb_result r = {.size = sizeof r};
    fmb_box *box = NULL;
    fmb_system *out = NULL;
    fmb_evidence *e = NULL;
    int keep[] = {0};
    fmb_optimum *best = NULL;
    double coef[16] = {2, -1, 0, 1, 3, -0.5};
    fmb_objective form = {fmb_system_rows(s) % 2 ? FMB_SENSE_MAX : FMB_SENSE_MIN, coef, 1};
    must(which == 0   ? fmb_solve(v, s, &r)
         : which == 1 ? fmb_bound(v, s, NULL, 0, &box, &r)
         : which == 2 ? fmb_reduce(v, s, NULL, &out, &r)
         : which == 3 ? fmb_optimize(v, s, &form, &best, &r)
                      : fmb_project(v, s, keep, 1, &out, &r));
    must(fmb_solver_evidence(v, &e));
    fmb_box_free(box);
    fmb_optimum_free(best);
    fmb_system_free(out);
    return e;
}

Test(mutate, proofs_of_the_solver, .timeout = 600)
{
    tally right = {0}, t = {0};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = FMB_EVIDENCE_WHOLE;
    must(fmb_solver_new(&o, NULL, &v));
    for (uint64_t seed = 0; t.judged < 30000 / WATCHED; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case c = support_make(family, seed, NULL);
            fmb_evidence *e = ask(v, c.s, (int)(seed % 5));
            if (fmb_evidence_claims(e) > 0) {
                judge(c.s, e, "as the solver made it", &right);
                mutate(c.s, e, seed * SUPPORT_FAMILIES + family, 10, &t);
            }
            fmb_evidence_free(e);
            support_case_clear(&c);
        }
    fmb_solver_free(v);
    cr_expect_eq(right.accepted, right.judged);
    cr_expect_geq(t.accepted, 300 / WATCHED);
    cr_expect_geq(t.judged - t.accepted, 5000 / WATCHED);
    for (fmb_claim_kind kind = FMB_CLAIM_FEASIBLE; kind <= FMB_CLAIM_FOLLOWS; kind++)
        cr_expect_geq(t.by_kind[kind], 100 / WATCHED, "kind %d: %d", kind, t.by_kind[kind]);
}

/* One byte for another, mostly a digit for a digit. */
static void change_byte(support_rng *g, char *text)
{
    static const char bytes[] = "0123456789-/<>= \n\"#\\xyrowpointend";
    size_t length = strlen(text), at = subject_any(g, length);
    bool digit = support_chance(g, 80);
    while (digit && !strchr("0123456789", text[at]))
        at = (at + 1) % length;
    text[at] = bytes[subject_any(g, digit ? 10 : sizeof bytes - 1)];
}

/* Bytes of the text changed: refused by the reader, or judged as the naive judge does. */
Test(mutate, text)
{
    support_rng g = {7};
    int parsed = 0;
    for (int k = 0; k < 20000 / WATCHED; k++) {
        const proof_sample *p = &proof_samples[subject_any(&g, proof_samples_count)];
        fmb_system *s = proof_system(p->system, NULL);
        fmb_evidence *e = proof_claims(s, p->claims);
        char *text = proof_text(s, e);
        fmb_evidence_free(e);
        for (int n = support_between(&g, 1, 3); n > 0; n--)
            change_byte(&g, text);
        fmb_where where;
        fmb_status st = proof_parse(s, text, &e, &where);
        cr_assert(st == FMB_OK || (st == FMB_ERR_PARSE && where.line > 0 && where.column > 0));
        if (st == FMB_OK) {
            tally t = {0};
            judge(s, e, text, &t);
            fmb_evidence_free(e);
            parsed++;
        }
        free(text);
        fmb_system_free(s);
    }
    cr_expect_geq(parsed, 2000 / WATCHED, "%d", parsed);
}
