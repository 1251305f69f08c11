/* limits.c: limits on reading and judging proofs, and the growth of the work with the proof:
 * counted in calls of the `patient` callback, not in seconds. */
#include <criterion/criterion.h>
#include <string.h>

#include "samples.h"

/* Gives up at a question, and counts them. */
typedef struct patient {
    size_t asked, most;
} patient;

static bool ask_patient(void *self)
{
    patient *p = self;
    return ++p->asked > p->most;
}

static fmb_judgement judge_with(const fmb_system *s, const fmb_evidence *e, patient *p)
{
    fmb_judgement j = {.size = sizeof j};
    fmb_patience wait = {.size = sizeof wait};
    wait.give_up = ask_patient;
    wait.self = p;
    cr_assert_eq(fmb_check_within(s, e, &wait, &j), FMB_OK);
    return j;
}

static const char triangle[] = "claim feasible\npoint x 1\nend\n"
                               "claim bound upper x <= 2\nrow 1 1\nrow 3 1\npoint x 2\nend\n"
                               "claim bound lower x >= 0\nrow 2 1\npoint x 0\nend\n";

/* Wherever a judge is stopped, nothing is accepted; with one question more, all is. */
Test(limits, every_question)
{
    fmb_system *s = proof_system("x y\n1 1 <= 2\n-1 0 <= 0\n0 -1 <= 0", NULL);
    fmb_evidence *e = proof_claims(s, triangle);
    patient forever = {.most = SIZE_MAX};
    fmb_judgement all = judge_with(s, e, &forever);
    cr_assert(all.accepted && all.stop == FMB_STOP_DONE && all.held == 3, "%s", all.reason);
    size_t held = 0;
    for (size_t most = 0; most < forever.asked; most++) {
        patient p = {.most = most};
        fmb_judgement j = judge_with(s, e, &p);
        cr_expect(!j.accepted && j.verdict == FMB_UNKNOWN && j.stop == FMB_STOP_CANCELLED);
        cr_expect(j.held < 3 && j.held >= held && j.claim == SIZE_MAX);
        held = j.held;
    }
    cr_expect_eq(held, 2);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

Test(limits, bytes)
{
    fmb_system *s = proof_system("x y\n1 1 <= 2\n-1 0 <= 0\n0 -1 <= 0", NULL);
    fmb_evidence *e = proof_claims(s, triangle);
    fmb_patience wait = {.size = sizeof wait};
    fmb_judgement j = {.size = sizeof j};
    size_t stopped = 0;
    for (wait.max_bytes = 1; !j.accepted; wait.max_bytes += 100, stopped++) {
        cr_assert_eq(fmb_check_within(s, e, &wait, &j), FMB_OK);
        cr_expect_eq(j.stop, j.accepted ? FMB_STOP_DONE : FMB_STOP_BYTES);
    }
    cr_expect_gt(stopped, 2);
    wait.max_seconds = -1;
    cr_expect_eq(fmb_check_within(s, e, &wait, &j), FMB_ERR_ARG);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

/* A text that is cut short by its reader is no proof, and no error. */
Test(limits, reading)
{
    fmb_system *s = proof_system("x y\n1 1 <= 2", NULL);
    char text[4096] = "fmb-proof 5\nsystem 1 rows 2 variables\n#";
    memset(text + strlen(text), '.', 3000);
    strcat(text, "\nclaim feasible\nend\nclaims 1\n");
    for (size_t most = 0; most < 16; most++) {
        patient p = {.most = most};
        fmb_patience wait = {.size = sizeof wait};
        wait.give_up = ask_patient;
        wait.self = &p;
        fmb_evidence *e = NULL;
        fmb_stop stop = FMB_STOP_ROWS;
        FILE *in = fmemopen(text, strlen(text), "r");
        cr_assert_not_null(in);
        cr_expect_eq(fmb_evidence_read_within(in, s, &wait, &e, &stop, NULL), FMB_OK);
        fclose(in);
        cr_expect_eq(e != NULL, p.asked <= most);
        cr_expect_eq(stop, e ? FMB_STOP_DONE : FMB_STOP_CANCELLED);
        fmb_evidence_free(e);
    }
    fmb_system_free(s);
}

static void expect_meets(const fmb_system *s, const fmb_evidence *e, fmb_demand what,
                         const fmb_patience *wait, fmb_stop expected, bool answer)
{
    fmb_stop stop = FMB_STOP_ROWS;
    bool meets = !answer;
    char why[80] = "untouched";
    cr_assert_eq(fmb_evidence_meets_within(e, s, what, s, wait, &stop, &meets, why, sizeof why),
                 FMB_OK);
    cr_expect_eq(stop, expected);
    cr_expect_eq(meets, answer);
    cr_expect_eq(strcmp(why, "untouched") == 0, stop != FMB_STOP_DONE || meets, "%s", why);
}

/* Whenever somebody gives up, whatever is wanted, it is neither there nor missing; with one
 * question more it is as if nobody had been in a hurry. */
Test(limits, demands)
{
    fmb_system *s = proof_system("x y\n1 1 <= 2\n-1 0 <= 0\n0 -1 <= 0", NULL);
    fmb_evidence *e = proof_claims(s, triangle);
    for (int what = FMB_DEMAND_FEASIBLE; what <= FMB_DEMAND_OPTIMUM; what++) {
        patient p = {.most = SIZE_MAX};
        fmb_patience wait = {.size = sizeof wait, .give_up = ask_patient, .self = &p};
        bool answer = what == FMB_DEMAND_FEASIBLE || what == FMB_DEMAND_OPTIMUM;
        expect_meets(s, e, (fmb_demand)what, &wait, FMB_STOP_DONE, answer);
        size_t all = p.asked;
        cr_expect_gt(all, 0);
        for (size_t most = 0; most < all; most++) {
            p = (patient){.most = most};
            expect_meets(s, e, (fmb_demand)what, &wait, FMB_STOP_CANCELLED, false);
        }
        wait = (fmb_patience){.size = sizeof wait, .max_bytes = 1};
        expect_meets(s, e, (fmb_demand)what, &wait, FMB_STOP_BYTES, false);
        wait.max_seconds = -1;
        fmb_stop stop;
        bool meets;
        cr_expect_eq(
            fmb_evidence_meets_within(e, s, (fmb_demand)what, s, &wait, &stop, &meets, NULL, 0),
            FMB_ERR_ARG);
    }
    fmb_evidence_free(e);
    fmb_system_free(s);
}

/* Questions until a proof that the cube of n variables is all of itself is accepted. */
static size_t questions_of_cube(int n)
{
    fmb_system *s = NULL;
    fmb_evidence *e = NULL;
    fmb_claim *c = NULL;
    patient p = {.most = SIZE_MAX};
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    cr_assert_eq(fmb_system_new(n, NULL, &s), FMB_OK);
    for (int r = 0; r < 2 * n; r++) {
        int64_t a[16] = {0};
        a[r / 2] = r % 2 ? -1 : 1;
        cr_assert_eq(fmb_system_add_int(s, a, FMB_LE, 1 - r % 2), FMB_OK);
    }
    cr_assert_eq(fmb_evidence_new(n, 2 * (size_t)n, NULL, &e), FMB_OK);
    mpq_t minus;
    mpq_init(minus);
    mpq_neg(minus, one);
    for (int r = 0; r < 2 * n; r++) {
        cr_assert_eq(fmb_evidence_claim(e, FMB_CLAIM_IMPLIED, &c), FMB_OK);
        c->rel = FMB_LE;
        mpq_set_ui(c->value, 1 - (unsigned)r % 2, 1);
        cr_assert_eq(fmb_evidence_push(e, &c->terms, (size_t)r / 2, r % 2 ? minus : one), FMB_OK);
        cr_assert_eq(fmb_evidence_push(e, &c->multipliers, (size_t)r, one), FMB_OK);
    }
    for (size_t g = 0; g < (size_t)1 << n; g++) {
        cr_assert_eq(fmb_evidence_claim(e, FMB_CLAIM_CORNER, &c), FMB_OK);
        for (size_t j = 0; j < (size_t)n; j++)
            if (g >> j & 1)
                cr_assert_eq(fmb_evidence_push(e, &c->point, j, one), FMB_OK);
    }
    cr_assert_eq(fmb_evidence_claim(e, FMB_CLAIM_WHOLE, &c), FMB_OK);
    for (size_t j = 0; j < (size_t)n; j++)
        cr_assert_eq(fmb_evidence_push(e, &c->terms, j, one), FMB_OK);
    fmb_judgement j = judge_with(s, e, &p);
    cr_expect(j.accepted, "%s", j.reason);
    mpq_clears(one, minus, NULL);
    fmb_evidence_free(e);
    fmb_system_free(s);
    return p.asked;
}

/* A cube has three times the faces of one of a dimension less, but not three times the corners: no
 * face is asked about. */
Test(limits, cubes)
{
    size_t before = questions_of_cube(6);
    for (int n = 7; n <= 14; n++) {
        size_t now = questions_of_cube(n);
        cr_expect_lt(2 * now, 5 * before, "%d: %zu after %zu", n, now, before);
        before = now;
    }
}
