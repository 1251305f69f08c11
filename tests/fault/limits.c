/* limits.c: a limit is a result: the stop says which, the verdict is unknown or right, and the
 * solver goes on. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/io.h>

#include "counted_clock.h"
#include "property/random/rows.h"
#include "samples.h"
#include "verbs.h"

static fmb_options options(fmb_method method)
{
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_ALL;
    o.method = method;
    return o;
}

/* Ask with limits; the stop is DONE, and the answer then the truth, or `stop`. */
static fmb_stop ask(const verb *w, const fmb_options *o, const fmb_system *s, fmb_stop stop,
                    const char *expected)
{
    char answer[VERB_ANSWER] = "";
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    must(fmb_solver_new(o, NULL, &v));
    must(w->ask(v, s, &r, answer));
    fmb_solver_free(v);
    if (r.stop == FMB_STOP_DONE) {
        cr_assert_str_eq(answer, expected, "%s under a limit", w->name);
        return r.stop;
    }
    cr_assert_eq(r.stop, stop, "%s stopped for %s", w->name, fmb_stop_text(r.stop));
    const char *verdict = fmb_verdict_text(r.verdict);
    cr_assert(r.verdict == FMB_UNKNOWN || strstr(expected, verdict), "%s: %s", w->name, verdict);
    return r.stop;
}

typedef void set_limit(fmb_options *o, size_t i);

static void set_rows(fmb_options *o, size_t i)
{
    o->max_rows = i;
}

static void set_bytes(fmb_options *o, size_t i)
{
    o->max_bytes = 64 * i;
}

/* Looser and looser limits on the first `verbs` queries: the tightest stops each, the loosest none.
 */
static void every_limit(set_limit *set, size_t most, fmb_stop stop, fmb_method method, int verbs)
{
    for (int i = 0; i < samples_count(); i++) {
        fmb_system *s = sample(i, NULL);
        for (int q = 0; q < verbs; q++) {
            char truth[VERB_ANSWER] = "";
            fmb_options o = options(method);
            fmb_result r = {.size = sizeof r};
            fmb_solver *v = NULL;
            must(fmb_solver_new(&o, NULL, &v));
            must(VERBS[q].ask(v, s, &r, truth));
            fmb_solver_free(v);
            set(&o, 1);
            fmb_stop tightest = ask(&VERBS[q], &o, s, stop, truth);
            bool needs_rows = VERBS[q].ask == VERBS[0].ask || !strstr(truth, "infeasible");
            cr_expect(tightest == stop || (set == set_rows && !needs_rows), "%s: no limit at 1",
                      VERBS[q].name);
            for (size_t k = 2; k < most; k += 1 + k * WATCHED / 16) {
                set(&o, k);
                ask(&VERBS[q], &o, s, stop, truth);
            }
            set(&o, most);
            cr_expect_eq(ask(&VERBS[q], &o, s, stop, truth), FMB_STOP_DONE);
        }
        fmb_system_free(s);
    }
}

/* Only solve and project eliminate, and project only what has a solution. */
Test(limits, rows)
{
    every_limit(set_rows, 10000, FMB_STOP_ROWS, FMB_METHOD_FM, 2);
}

Test(limits, bytes)
{
    every_limit(set_bytes, 1 << 18, FMB_STOP_BYTES, FMB_METHOD_FM, VERBS_COUNT);
}

Test(limits, bytes_lp)
{
    every_limit(set_bytes, 1 << 18, FMB_STOP_BYTES, FMB_METHOD_LP, VERBS_COUNT);
}

Test(limits, bytes_dd)
{
    every_limit(set_bytes, 1 << 18, FMB_STOP_BYTES, FMB_METHOD_DD, 2);
}

/* A projection under looser and looser limits on bytes, by 1 / steps each, until it is done. */
static size_t count_tight_limits(const fmb_system *s, size_t steps)
{
    char truth[VERB_ANSWER] = "";
    fmb_options o = options(FMB_METHOD_AUTO);
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    size_t tries = 0;
    must(fmb_solver_new(&o, NULL, &v));
    must(VERBS[1].ask(v, s, &r, truth));
    fmb_solver_free(v);
    set_bytes(&o, 1);
    for (size_t k = 1; ask(&VERBS[1], &o, s, FMB_STOP_BYTES, truth) != FMB_STOP_DONE; tries++) {
        k += 1 + k * WATCHED / steps;
        set_bytes(&o, k);
    }
    return tries;
}

/* One that is walked around. */
Test(limits, polygon)
{
    fmb_system *s = sample_hard(5, 18, NULL);
    cr_expect_gt(count_tight_limits(s, 512), 100 / WATCHED);
    fmb_system_free(s);
}

static void under_tight_limits(const char *rows)
{
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_TEXT};
    fmb_system *s = NULL;
    must(fmb_system_parse(rows, strlen(rows), &how, &s, NULL));
    cr_expect_gt(count_tight_limits(s, 4096), 100 / WATCHED);
    fmb_system_free(s);
}

/* The limit comes when all is known, and rows are claimed one by one. */
Test(limits, polygon_of_long_rows)
{
    under_tight_limits("vars: x z y\n"
                       "2x+2y-z<=2341020015902972/1000000007\n"
                       "-3x+3y+z<=160465001607423/1000000007\n"
                       "3x<=1675531\n"
                       "x+3y+3z<=2394506018214046/1000000007\n"
                       "-2x-y-3z<=-1729016013555616/1000000007\n"
                       "-y-3z<=-611994005736462/1000000007\n"
                       "-3y-z<=-1835990013336098/1000000007\n"
                       "-2x+3y<=718977\n"
                       "3z<=4001452532/1000000007\n"
                       "2x-2y-2z<=-106975001717161/1000000007\n");
}

/* The limit comes when support queries are opened. */
Test(limits, interval_of_long_rows)
{
    under_tight_limits(
        "vars: z y w x\n"
        "28x<=1385115\n"
        "25y+17z<=118998477530999997067109385381990/100000000700000000039000000273\n"
        "-83x+59y<=-2874107400000000001170119922/700000000000000000273\n"
        "x<=346285/7\n"
        "z<=70999104437/1000000007\n"
        "-z<=-68999104423/1000000007\n"
        "-51z<=-3569954325930/1000000007\n"
        "93x-65y<=3220385400000000001310173566/700000000000000000273\n"
        "-69x-91z<=-23937771596774184/7000000049\n"
        "79y-78z<=-545993014554000009627525341578176/100000000700000000039000000273\n"
        "13y<=199999999999998450842/100000000000000000039\n"
        "y<=99999999999999880867/100000000000000000039\n"
        "-y<=119172/100000000000000000039\n"
        "w<=1\n");
}

/* Ask with a limit of time: the clock is not read again once it has shown the end, but to say how
 * long it took, and where time is kept for what follows a limit. */
enum { AFTER_THE_LIMIT = 2 };

static void expect_time(const verb *w, const fmb_system *s, size_t seconds)
{
    fmb_options o = options(FMB_METHOD_FM);
    char answer[VERB_ANSWER] = "";
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    o.max_seconds = (double)seconds;
    must(fmb_solver_new(&o, NULL, &v));
    counted_clock_start(0, NULL, NULL);
    must(w->ask(v, s, &r, answer));
    counted_clock_stop();
    cr_assert_eq(r.stop, FMB_STOP_TIME, "%s: %s", w->name, fmb_stop_text(r.stop));
    cr_assert_neq(r.verdict, FMB_INFEASIBLE);
    size_t readings = counted_clock_readings();
    cr_assert_eq(r.stats.seconds, (double)(readings - 1));
    cr_assert_leq(readings, 1 + seconds + AFTER_THE_LIMIT, "%s: %zu s, %zu readings", w->name,
                  seconds, readings);
    fmb_solver_free(v);
}

Test(limits, seconds)
{
    fmb_system *s = sample_hard(12, 40, NULL);
    for (int q = 0; q < VERBS_COUNT; q++)
        for (size_t seconds = 1; seconds < 40; seconds += 1 + seconds / 4)
            expect_time(&VERBS[q], s, seconds);
    expect_time(&VERBS[0], s, 1000);
    fmb_system_free(s);
}

/* What a limited query hands out: a projection without rows, ends unknown, rows kept. */
Test(limits, outputs)
{
    static const int keep[] = {0, 1};
    fmb_system *s = sample_hard(12, 40, NULL), *out = s;
    fmb_options o = options(FMB_METHOD_FM);
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_box *box = NULL;
    fmb_fate fate[40];
    o.max_seconds = 1;
    must(fmb_solver_new(&o, NULL, &v));
    counted_clock_start(0, NULL, NULL);
    must(fmb_project(v, s, keep, 2, &out, &r));
    cr_assert(r.stop == FMB_STOP_TIME && out && fmb_system_dim(out) == 2);
    fmb_system_free(out);
    must(fmb_bound(v, s, NULL, 0, &box, &r));
    cr_assert_eq(r.stop, FMB_STOP_TIME);
    for (int i = 0; box && i < fmb_box_size(box); i++)
        cr_assert_eq(fmb_box_end(box, i, FMB_LOWER).kind, FMB_END_UNKNOWN);
    fmb_box_free(box);
    must(fmb_reduce(v, s, fate, &out, &r));
    counted_clock_stop();
    cr_assert_eq(r.stop, FMB_STOP_TIME);
    cr_assert_eq(fmb_system_rows(out), 40);
    for (size_t i = 0; i < 40; i++)
        cr_assert(fate[i] == FMB_FATE_UNKNOWN && rows_equal(s, i, out, i));
    fmb_system_free(out);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* Two variables in many rows: elimination would pair them all, each pair with a long history. */
Test(limits, many_rows_of_two_variables)
{
    enum { ROWS = 4000 };
    fmb_options o = options(FMB_METHOD_AUTO);
    fmb_result r = {.size = sizeof r};
    fmb_system *s = NULL;
    fmb_solver *v = NULL;
    must(fmb_system_new(2, NULL, &s));
    for (int64_t i = 0; i < ROWS; i++)
        must(fmb_system_add_int(s, (int64_t[]){i * 37 % ROWS - ROWS / 2, i * 91 % ROWS - ROWS / 2},
                                FMB_LE, 1 + i * 53 % ROWS));
    o.max_bytes = (size_t)4 << 20;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    cr_expect_eq(r.stop, FMB_STOP_DONE, "%s", fmb_stop_text(r.stop));
    cr_expect_eq(r.verdict, FMB_FEASIBLE);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* x_j in [1, j + 1]: each end of each variable comes with a point that has no zero. */
static fmb_system *many_intervals(int dim)
{
    fmb_system *s = NULL;
    mpq_t one, end;
    mpq_inits(one, end, NULL);
    must(fmb_system_new(dim, NULL, &s));
    for (int j = 0; j < dim; j++)
        for (int sign = -1; sign <= 1; sign += 2) {
            mpq_set_si(one, sign, 1);
            mpq_set_si(end, sign < 0 ? -1 : j + 1, 1);
            must(fmb_system_add_q(s, 1, &j, &one, FMB_LE, end));
        }
    mpq_clears(one, end, NULL);
    return s;
}

/* Evidence is what grows here: it counts together with all the rest, what is proved so far stays,
 * and to keep less is a way out. */
Test(limits, bytes_of_evidence)
{
    fmb_options o = options(FMB_METHOD_AUTO);
    fmb_result r = {.size = sizeof r};
    fmb_system *s = many_intervals(500);
    fmb_solver *v = NULL;
    fmb_box *box = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    o.max_bytes = (size_t)4 << 20;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_bound(v, s, NULL, 0, &box, &r));
    cr_expect_eq(r.stop, FMB_STOP_BYTES, "%s", fmb_stop_text(r.stop));
    cr_expect_leq(r.stats.bytes_peak, o.max_bytes);
    cr_expect_eq(fmb_box_end(box, 0, FMB_LOWER).kind, FMB_END_FINITE);
    cr_expect_neq(fmb_box_end(box, 499, FMB_UPPER).kind, FMB_END_FINITE);
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_expect(j.accepted && j.verdict == FMB_FEASIBLE && fmb_evidence_claims(e) > 20, "%s",
              j.reason);
    fmb_box_free(box);
    fmb_solver_free(v);
    cr_expect_eq(fmb_evidence_kind(e, 0), FMB_CLAIM_FEASIBLE, "it outlives the solver");
    fmb_evidence_free(e);
    o.evidence = FMB_EVIDENCE_VERDICT;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_bound(v, s, NULL, 0, &box, &r));
    cr_expect_eq(r.stop, FMB_STOP_DONE, "%s", fmb_stop_text(r.stop));
    must(fmb_solver_evidence(v, &e));
    cr_expect_eq(fmb_evidence_claims(e), 1);
    fmb_evidence_free(e);
    fmb_box_free(box);
    fmb_solver_free(v);
    fmb_system_free(s);
}
