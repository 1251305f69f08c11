/* cancel.c: a query is cancelled from another thread wherever it reads the clock, and the solver
 * then gives right answers at once. */
#include <criterion/criterion.h>
#include <pthread.h>

#include "counted_clock.h"
#include "property/random/rows.h"
#include "samples.h"
#include "verbs.h"

static void *cancel(void *v)
{
    fmb_solver_cancel(v);
    return NULL;
}

static void cancel_from_another_thread(void *v)
{
    pthread_t thread;
    cr_assert_eq(pthread_create(&thread, NULL, cancel, v), 0);
    cr_assert_eq(pthread_join(thread, NULL), 0);
}

/* The next query of the same solver. */
static void expect_usable(fmb_solver *v, const fmb_system *s, fmb_verdict verdict)
{
    char answer[VERB_ANSWER] = "";
    fmb_result r = {.size = sizeof r};
    must(VERBS[0].ask(v, s, &r, answer));
    cr_assert_eq(r.stop, FMB_STOP_DONE, "%s", fmb_stop_text(r.stop));
    cr_assert_eq(r.verdict, verdict);
}

static fmb_solver *solver_that_reads_the_clock(fmb_method method)
{
    return must_open((fmb_options){.method = method, .max_seconds = COUNTED_FOREVER});
}

/* Cancelled at reading `at` of the clock, the query notes it before it reads the clock again to go
 * on: what is left is the reading at its end. */
static void cancel_at(fmb_solver *v, const verb *w, const fmb_system *s, size_t at)
{
    char answer[VERB_ANSWER] = "";
    fmb_result r = {.size = sizeof r};
    counted_clock_start(at, cancel_from_another_thread, v);
    must(w->ask(v, s, &r, answer));
    counted_clock_stop();
    cr_assert_eq(r.stop, FMB_STOP_CANCELLED, "%s, %zu: %s", w->name, at, fmb_stop_text(r.stop));
    cr_assert_neq(r.verdict, FMB_INFEASIBLE);
    cr_assert_eq(counted_clock_readings(), at + 1, "%s, cancelled at %zu: asked until %zu", w->name,
                 at, counted_clock_readings());
}

/* Elimination of what takes far longer than any test, at its beginning and later on. */
Test(cancel, from_another_thread)
{
    fmb_system *hard = sample_hard(40, 120, NULL), *easy = sample(1, NULL);
    fmb_solver *v = solver_that_reads_the_clock(FMB_METHOD_FM);
    for (int w = 0; w < VERBS_COUNT; w++)
        for (size_t at = 2; at < 150; at += 1 + at / 8) {
            cancel_at(v, &VERBS[w], hard, at);
            expect_usable(v, easy, FMB_INFEASIBLE);
        }
    fmb_solver_free(v);
    fmb_system_free(hard);
    fmb_system_free(easy);
}

/* A projection that is walked around, from its beginning to its end. */
Test(cancel, polygon)
{
    fmb_system *hard = sample_hard(20, 60, NULL), *easy = sample(1, NULL);
    fmb_solver *v = solver_that_reads_the_clock(FMB_METHOD_AUTO);
    char answer[VERB_ANSWER] = "";
    fmb_result r = {.size = sizeof r};
    counted_clock_start(0, NULL, NULL);
    must(VERBS[1].ask(v, hard, &r, answer));
    counted_clock_stop();
    size_t all = counted_clock_readings();
    cr_assert(r.stop == FMB_STOP_DONE && all > 100, "%zu", all);
    for (size_t at = 2; at < all; at += all / 16 + 1) {
        cancel_at(v, &VERBS[1], hard, at);
        expect_usable(v, easy, FMB_INFEASIBLE);
    }
    fmb_solver_free(v);
    fmb_system_free(hard);
    fmb_system_free(easy);
}

/* A cancel that comes while nothing runs touches no later query. */
Test(cancel, before)
{
    fmb_system *easy = sample(1, NULL);
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    fmb_solver_cancel(v);
    expect_usable(v, easy, FMB_INFEASIBLE);
    fmb_solver_cancel(v);
    expect_usable(v, easy, FMB_INFEASIBLE);
    fmb_solver_free(v);
    fmb_system_free(easy);
}
