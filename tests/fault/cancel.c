/* cancel.c: a query is cancelled from another thread at random moments, and the solver then gives
 * right answers at once. */
#include <criterion/criterion.h>
#include <pthread.h>
#include <stdatomic.h>
#include <time.h>

#include "property/random/rows.h"
#include "samples.h"
#include "verbs.h"

typedef struct scene {
    fmb_solver *v;
    atomic_bool running; /* set by the query's first event */
    atomic_bool over;    /* set when it has returned */
    unsigned wait;       /* [ns] from then to the cancel */
} scene;

static void note(void *self, const fmb_event *e)
{
    scene *c = self;
    if (e->kind == FMB_EVENT_BEGIN)
        atomic_store(&c->running, true);
}

static void *canceller(void *self)
{
    scene *c = self;
    while (!atomic_load(&c->running) && !atomic_load(&c->over))
        nanosleep(&(struct timespec){0, 1000}, NULL);
    nanosleep(&(struct timespec){0, c->wait}, NULL);
    fmb_solver_cancel(c->v);
    return NULL;
}

/* The next query of the same solver. */
static void expect_usable(fmb_solver *v, const fmb_system *s, fmb_verdict verdict)
{
    char answer[VERB_ANSWER] = "";
    fmb_result r = {0};
    must(VERBS[0].ask(v, s, &r, answer));
    cr_assert_eq(r.stop, FMB_STOP_DONE, "%s", fmb_stop_text(r.stop));
    cr_assert_eq(r.verdict, verdict);
}

static void one_try(scene *c, const verb *w, const fmb_system *s, int *cancelled)
{
    pthread_t thread;
    char answer[VERB_ANSWER] = "";
    fmb_result r = {0};
    atomic_store(&c->running, false);
    atomic_store(&c->over, false);
    cr_assert_eq(pthread_create(&thread, NULL, canceller, c), 0);
    must(w->ask(c->v, s, &r, answer));
    atomic_store(&c->over, true);
    pthread_join(thread, NULL);
    cr_assert(r.stop == FMB_STOP_CANCELLED || r.stop == FMB_STOP_DONE, "%s", fmb_stop_text(r.stop));
    cr_assert_neq(r.verdict, FMB_INFEASIBLE);
    *cancelled += r.stop == FMB_STOP_CANCELLED;
}

/* The verbs w[0..verbs) in turn, each cancelled after at most `most` ns; how many were. */
static int cancel_often(fmb_method method, const verb *w, int verbs, int tries, unsigned most)
{
    fmb_system *hard = sample_hard(40, 120, NULL), *easy = sample(1, NULL);
    fmb_options o = fmb_options_default();
    scene c = {0};
    unsigned seed = 7;
    int cancelled = 0;
    o.evidence = true;
    o.method = method;
    o.max_seconds = 20;
    must(fmb_solver_new(&o, NULL, &c.v));
    fmb_solver_set_sink(c.v, (fmb_sink){note, &c});
    for (int i = 0; i < tries; i++) {
        seed = seed * 1664525u + 1013904223u;
        c.wait = (seed >> 8) % (i % 2 ? most : most / 40);
        one_try(&c, &w[i % verbs], hard, &cancelled);
        expect_usable(c.v, easy, FMB_INFEASIBLE);
    }
    fmb_solver_free(c.v);
    fmb_system_free(hard);
    fmb_system_free(easy);
    return cancelled;
}

Test(cancel, from_another_thread)
{
    int cancelled = cancel_often(FMB_METHOD_FM, VERBS, VERBS_COUNT, 400, 4000000);
    cr_assert_gt(cancelled, 360, "only %d were cancelled", cancelled);
}

/* A projection that is walked around takes a tenth of a second or so. */
Test(cancel, polygon)
{
    int cancelled = cancel_often(FMB_METHOD_AUTO, &VERBS[1], 1, 100, 12000000);
    cr_assert_gt(cancelled, 25, "only %d were cancelled", cancelled);
}

/* A cancel that comes while nothing runs touches no later query. */
Test(cancel, before)
{
    fmb_system *easy = sample(1, NULL);
    fmb_options o = fmb_options_default();
    fmb_solver *v = NULL;
    o.evidence = true;
    must(fmb_solver_new(&o, NULL, &v));
    fmb_solver_cancel(v);
    expect_usable(v, easy, FMB_INFEASIBLE);
    fmb_solver_cancel(v);
    expect_usable(v, easy, FMB_INFEASIBLE);
    fmb_solver_free(v);
    fmb_system_free(easy);
}
