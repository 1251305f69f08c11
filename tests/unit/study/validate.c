/* validate.c: the judge of pairs detects false answers; shares of a validation merge into one. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/solve.h>

#include "study/reference/ends.h"
#include "study/reference/truth.h"
#include "study/reference/validate.h"
#include "support/must.h"

/* ---- the textbook truth ---------------------------------------------------------------------- */

/* Unit squares side by side touch; who says otherwise, in whichever way and order, is found out. */
Test(truth, contradicts_what_is_false)
{
    const double axes[] = {1, 0, 0, 1}, here[] = {0, 0}, beside[] = {1, 0};
    const fmb_frame p = {FMB_CUBOID, 2, 2, here, axes, NULL},
                    q = {FMB_CUBOID, 2, 2, beside, axes, NULL};
    const size_t index = 0;
    atomic_bool stopped = false;
    for (int way = STUDY_FMB_CLOSED; way <= STUDY_PAIR_WAYS; way++)
        for (int order = 0; order < 2; order++) {
            study_verdicts v = {.asked = (1U << STUDY_PAIR_WAYS) - 1};
            unsigned faults = 0;
            uint64_t answered = 0, left = 0;
            for (int w = STUDY_FMB_CLOSED; w < STUDY_PAIR_WAYS; w++) {
                bool open = w == STUDY_FMB_OPEN || w == STUDY_SAT_OPEN || w == STUDY_EXACT_OPEN;
                v.said[w][0] = v.said[w][1] = open ? FMB_INFEASIBLE : FMB_FEASIBLE;
            }
            if (way < STUDY_PAIR_WAYS)
                v.said[way][order] =
                    v.said[way][order] == FMB_FEASIBLE ? FMB_INFEASIBLE : FMB_FEASIBLE;
            must(study_truth_run(1, &p, &q, &index, &v, &faults, &stopped, &answered, &left));
            cr_expect_eq(faults, way < STUDY_PAIR_WAYS ? STUDY_FAULT_TEXTBOOK : 0u, "%d", way);
            cr_expect(answered == 1 && left == 0);
        }
}

/* ---- verdicts -------------------------------------------------------------------------------- */

/* Everybody says the same; closed frames may meet where open ones do not. */
static study_verdicts all_say(fmb_verdict closed, fmb_verdict open)
{
    study_verdicts v = {.asked = (1U << STUDY_PAIR_WAYS) - 1};
    for (int way = 0; way < STUDY_PAIR_WAYS; way++) {
        fmb_pair_options o = study_way_options((study_way_of_pairs)way, FMB_SIMD_AUTO);
        fmb_verdict x = o.contact == FMB_CONTACT_OPEN ? open : closed;
        if (o.doubles_only && closed != open)
            x = FMB_UNKNOWN;
        v.said[way][0] = v.said[way][1] = x;
    }
    return v;
}

Test(judge, what_agrees)
{
    study_verdicts v = all_say(FMB_FEASIBLE, FMB_FEASIBLE);
    cr_expect_eq(study_verdict_faults(&v), 0u);
    v = all_say(FMB_INFEASIBLE, FMB_INFEASIBLE);
    cr_expect_eq(study_verdict_faults(&v), 0u);
    v = all_say(FMB_FEASIBLE, FMB_INFEASIBLE);
    cr_expect_eq(study_verdict_faults(&v), 0u, "they touch");
    v = all_say(FMB_INFEASIBLE, FMB_FEASIBLE);
    cr_expect_eq(study_verdict_faults(&v), (unsigned)STUDY_FAULT_CONTACT);
    v = all_say(FMB_FEASIBLE, FMB_FEASIBLE);
    v.said[STUDY_FMB_DOUBLES][1] = v.said[STUDY_SAT_DOUBLES][0] = FMB_UNKNOWN;
    cr_expect_eq(study_verdict_faults(&v), 0u, "doubles may leave a pair open");
}

/* Any one false answer is found, whatever is true, and named after what it contradicts. */
Test(judge, one_false_answer)
{
    const fmb_verdict truth[3][2] = {{FMB_FEASIBLE, FMB_FEASIBLE},
                                     {FMB_INFEASIBLE, FMB_INFEASIBLE},
                                     {FMB_FEASIBLE, FMB_INFEASIBLE}};
    for (int t = 0; t < 3; t++)
        for (int way = 0; way < STUDY_PAIR_WAYS; way++)
            for (int order = 0; order < 2; order++) {
                study_verdicts v = all_say(truth[t][0], truth[t][1]);
                fmb_verdict *said = &v.said[way][order];
                *said = *said == FMB_INFEASIBLE ? FMB_FEASIBLE : FMB_INFEASIBLE;
                unsigned faults = study_verdict_faults(&v);
                cr_expect(faults & STUDY_FAULT_ITSELF, "%d %d %d", t, way, order);
                cr_expect(faults & STUDY_FAULT_EXACT, "%d %d %d", t, way, order);
            }
}

/* A method may be wrong all of the time. */
Test(judge, one_false_method)
{
    study_verdicts v = all_say(FMB_FEASIBLE, FMB_FEASIBLE);
    for (int way = 0; way < STUDY_PAIR_WAYS; way++)
        if (study_way_method((study_way_of_pairs)way) == STUDY_BY_SAT)
            v.said[way][0] = v.said[way][1] = FMB_INFEASIBLE;
    cr_expect_eq(study_verdict_faults(&v), (unsigned)(STUDY_FAULT_SAT | STUDY_FAULT_EXACT));
    v.asked &= ~(1U << STUDY_EXACT_CLOSED | 1U << STUDY_EXACT_OPEN);
    cr_expect_eq(study_verdict_faults(&v), (unsigned)STUDY_FAULT_SAT);
}

Test(judge, undecided)
{
    for (int way = STUDY_FMB_CLOSED; way < STUDY_PAIR_WAYS; way++) {
        study_verdicts v = all_say(FMB_INFEASIBLE, FMB_INFEASIBLE);
        v.said[way][1] = FMB_UNKNOWN;
        cr_expect_eq(study_verdict_faults(&v), (unsigned)STUDY_FAULT_UNDECIDED, "%d", way);
    }
}

/* ---- boxes ----------------------------------------------------------------------------------- */

static const double ZERO[2], UNIT[4] = {1, 0, 0, 1}, PLACE[2] = {0.5, -99};
static const fmb_frame SQUARE = {FMB_CUBOID, 2, 2, ZERO, UNIT, NULL};
static const fmb_frame LONG = {
    FMB_CUBOID, 2, 2, PLACE, (const double[4]){1, 0, 0, 100}, (const double[2]){0, 5}};

typedef struct box {
    fmb_verdict verdict;
    double world[4], inside[4], time[2], witness[2];
} box;

static fmb_pair_answers answers(box *b)
{
    return (fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                              .verdict = &b->verdict,
                              .world = b->world,
                              .inside = b->inside,
                              .time = b->time,
                              .witness = b->witness};
}

static box exact_box(void)
{
    box b;
    fmb_pair_answers out = answers(&b);
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    o.method = FMB_PAIR_EXACT;
    must(fmb_pair_new(2, &o, NULL, &k));
    must(fmb_pair_test(k, 1, &SQUARE, &LONG, &out));
    cr_assert_eq(b.verdict, FMB_FEASIBLE);
    fmb_pair_free(k);
    return b;
}

Test(judge, largest_coordinate)
{
    cr_expect_eq(study_largest_coordinate(&SQUARE, &SQUARE), 1);
    cr_expect_eq(study_largest_coordinate(&SQUARE, &LONG), 99);
    fmb_frame simplex = LONG;
    simplex.shape = FMB_SIMPLEX;
    simplex.origin = ZERO;
    cr_expect_eq(study_largest_coordinate(&simplex, &SQUARE), 105);
}

/* Every end, moved a little in, a little out, and too far out. */
Test(judge, ends)
{
    box exact = exact_box();
    fmb_pair_answers truth = answers(&exact);
    for (int i = 0; i < 10; i++)
        for (int step = -1; step <= 2; step++) {
            box b = exact;
            fmb_pair_answers ours = answers(&b);
            double *end = i < 4 ? &b.world[i] : i < 8 ? &b.inside[i - 4] : &b.time[i - 8];
            double out = i % 2 ? 1 : -1, size = i < 4 ? 99 : 1, excess;
            *end += out * size * (step == 2 ? 2e-12 : step * 0.9e-12);
            unsigned usual = study_box_faults(&SQUARE, &LONG, &ours, &truth, false, &excess);
            unsigned tightest = study_box_faults(&SQUARE, &LONG, &ours, &truth, true, &excess);
            unsigned expected = step < 0 ? STUDY_FAULT_OUTSIDE : step > 1 ? STUDY_FAULT_WIDE : 0;
            cr_expect_eq(usual, expected, "%d %d: %u", i, step, usual);
            cr_expect_eq((tightest & STUDY_FAULT_TIGHTEST) != 0, step != 0, "%d %d", i, step);
        }
}

static fmb_verdict witness_verdict(double x, double y)
{
    fmb_system *s = NULL;
    fmb_solver *solver = NULL;
    fmb_result res = {.size = sizeof res};
    must(study_witness_system(&SQUARE, &LONG, (const double[2]){x, y}, &s));
    must(fmb_solver_new(NULL, NULL, &solver));
    must(fmb_solve(solver, s, &res));
    fmb_solver_free(solver);
    fmb_system_free(s);
    return res.verdict;
}

Test(judge, witnesses)
{
    cr_expect_eq(witness_verdict(0.75, 0.5), FMB_FEASIBLE);
    cr_expect_eq(witness_verdict(0.5 - 1e-13, 1), FMB_FEASIBLE);
    cr_expect_eq(witness_verdict(0.5 - 1e-9, 0.5), FMB_INFEASIBLE, "not in B");
    cr_expect_eq(witness_verdict(0.75, -0.1), FMB_INFEASIBLE, "not in A");
}

/* ---- runs ------------------------------------------------------------------------------------ */

static study_validation validation(study_pair_family family, bool boxes)
{
    return (study_validation){.plan = {.family = family,
                                       .dim = 2,
                                       .moves = true,
                                       .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}},
                              .seed = 3,
                              .sample = 0.25,
                              .textbook = 1,
                              .boxes = boxes};
}

static study_tally run(const study_validation *v, uint64_t first, size_t n)
{
    study_validator *s = NULL;
    study_tally t = {0};
    study_findings found = {0};
    must(study_validator_open(v, &s));
    must(study_validator_run(s, first, n, &t, &found));
    cr_expect_eq(found.n, 0u);
    study_validator_close(s);
    free(found.item);
    return t;
}

Test(validator, shares_add_up)
{
    study_validation v = validation(STUDY_PAIR_ARTICLE, true);
    study_tally whole = run(&v, 0, 400), sum = {0};
    for (uint64_t first = 0; first < 400; first += 100) {
        study_tally part = run(&v, first, 100);
        study_tally_add(&sum, &part);
    }
    cr_expect_eq(memcmp(&whole, &sum, sizeof sum), 0);
    cr_expect_eq(whole.tested, 400u);
    cr_expect(whole.meeting > 100 && whole.meeting < 200);
    cr_expect(whole.exact > 60 && whole.exact < 140, "a sample of a quarter: %d", (int)whole.exact);
    cr_expect(whole.boxes > 10 && whole.boxes < whole.exact);
}

Test(validator, hard_families_are_held_against_exact_all)
{
    study_validation v = validation(STUDY_PAIR_TOUCHING, false);
    study_tally t = run(&v, 0, 100);
    cr_expect(t.exact == 100 && t.touching == 100 && t.unknown[0] == 200 && t.unknown[1] == 200);
    cr_expect(t.boxes == 0 && t.disagreeing == 0);
}
