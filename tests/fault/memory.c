/* memory.c: the k-th allocation fails, for every k; under sanitizers for every eleventh
 * one, as each takes seven times as long there.
 *
 * Each time: the status is MEMORY, out arguments are untouched, the same solver then gives the
 * right answer, and when everything is freed not one byte is left.
 */
#include <criterion/criterion.h>
#include <string.h>

#include "hook.h"
#include "property/random/rows.h"
#include "samples.h"
#include "verbs.h"

static const char *const RULES[] = {NULL, "none", "kohler", "duplicate,kohler"};

/* Double description proves its projections whole, too. */
static fmb_solver *solver(hook *h, fmb_method method, const char *rules)
{
    fmb_options o = {.size = sizeof o};
    fmb_alloc mem = hook_alloc(h);
    fmb_solver *v = NULL;
    o.evidence = method == FMB_METHOD_DD ? FMB_EVIDENCE_WHOLE : FMB_EVIDENCE_ALL;
    o.method = method;
    o.rules = rules;
    must(fmb_solver_new(&o, &mem, &v));
    return v;
}

/* Ask once with request k failing; true if the query had fewer requests than k. */
static bool fails_well(const verb *w, hook *h, fmb_solver *v, const fmb_system *s, size_t k,
                       bool forever, const char *truth)
{
    char answer[VERB_ANSWER] = "";
    fmb_result r = {.size = sizeof r};
    hook_arm(h, k, forever);
    fmb_status st = w->ask(v, s, &r, answer);
    bool reached = h->calls >= k;
    hook_calm(h);
    if (!reached || st == FMB_OK) {
        cr_assert_eq(st, FMB_OK, "%s: %s", w->name, fmb_status_text(st));
        cr_assert_str_eq(answer, truth);
        return !reached;
    }
    cr_assert_eq(st, FMB_ERR_MEMORY, "%s, request %zu: %s", w->name, k, fmb_status_text(st));
    memset(answer, 0, sizeof answer);
    r = (fmb_result){.size = sizeof(fmb_result)};
    must(w->ask(v, s, &r, answer));
    cr_assert_str_eq(answer, truth, "%s after request %zu failed", w->name, k);
    return false;
}

/* Every k for one query, on a fresh solver each time. The system allocates through the hook too, so
 * that fmb_check does. */
static void every_request(const verb *w, int i, fmb_method method, const char *rules, bool forever)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    char truth[VERB_ANSWER] = "";
    fmb_system *s = sample(i, &mem);
    size_t before = h.live;
    fmb_solver *v = solver(&h, method, rules);
    fmb_result r = {.size = sizeof r};
    must(w->ask(v, s, &r, truth));
    fmb_solver_free(v);
    cr_assert_eq(h.live, before);
    bool past = false;
    for (size_t k = 1 + (size_t)i % WATCHED; !past; k += WATCHED) {
        v = solver(&h, method, rules);
        past = fails_well(w, &h, v, s, k, forever, truth);
        fmb_solver_free(v);
        cr_assert_eq(h.live, before, "%s, request %zu: %zu bytes leak", w->name, k,
                     h.live - before);
    }
    fmb_system_free(s);
    cr_assert_eq(h.live, 0);
}

static void every_sample(const verb *w)
{
    for (int i = 0; i < samples_count(); i++) {
        for (size_t k = 0; k < sizeof RULES / sizeof *RULES; k++)
            every_request(w, i, FMB_METHOD_FM, RULES[k], false);
        every_request(w, i, FMB_METHOD_AUTO, NULL, true);
        every_request(w, i, FMB_METHOD_LP, NULL, false);
        every_request(w, i, FMB_METHOD_HULL, NULL, false);
    }
}

Test(memory, solve)
{
    every_sample(&VERBS[0]);
}

Test(memory, project)
{
    every_sample(&VERBS[1]);
    for (int i = 0; i < samples_count(); i++)
        every_request(&VERBS[1], i, FMB_METHOD_DD, NULL, i % 2 == 0);
}

Test(memory, bound)
{
    every_sample(&VERBS[2]);
}

Test(memory, reduce)
{
    every_sample(&VERBS[3]);
}

Test(memory, optimize)
{
    every_sample(&VERBS[4]);
}

/* One solver outlives all failures. */
Test(memory, one_solver)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_solver *v = solver(&h, FMB_METHOD_AUTO, NULL);
    for (int i = 0; i < samples_count(); i++) {
        fmb_system *s = sample(i, &mem);
        for (int q = 0; q < VERBS_COUNT; q++) {
            char truth[VERB_ANSWER] = "";
            fmb_result r = {.size = sizeof r};
            must(VERBS[q].ask(v, s, &r, truth));
            bool past = false;
            for (size_t k = 1; !past; k += WATCHED)
                past = fails_well(&VERBS[q], &h, v, s, k, false, truth);
        }
        fmb_system_free(s);
    }
    fmb_solver_free(v);
    cr_assert_eq(h.live, 0);
}

/* After a failure there is no evidence, least of all that of the query before. */
Test(memory, no_stale_evidence)
{
    hook h = {0};
    fmb_solver *v = solver(&h, FMB_METHOD_AUTO, NULL);
    fmb_system *s = sample(0, NULL);
    fmb_evidence *e = NULL;
    for (int q = 0; q < VERBS_COUNT; q++) {
        char answer[VERB_ANSWER] = "";
        fmb_result r = {.size = sizeof r};
        must(VERBS[q].ask(v, s, &r, answer));
        r = (fmb_result){.size = sizeof(fmb_result)};
        hook_arm(&h, 1, false);
        cr_assert_eq(VERBS[q].ask(v, s, &r, answer), FMB_ERR_MEMORY);
        hook_calm(&h);
        cr_assert_eq(fmb_solver_evidence(v, &e), FMB_ERR_STATE, "%s", VERBS[q].name);
    }
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* Every request of one query on a system large enough for rows to sleep, or for a guess. */
static void every_large(const verb *w, int n, int m)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_solver *v = solver(&h, FMB_METHOD_AUTO, NULL);
    fmb_system *s = sample_hard(n, m, &mem);
    char truth[VERB_ANSWER] = "";
    fmb_result r = {.size = sizeof r};
    must(w->ask(v, s, &r, truth));
    for (size_t k = 1; !fails_well(w, &h, v, s, k, false, truth); k += WATCHED)
        ;
    fmb_system_free(s);
    fmb_solver_free(v);
    cr_assert_eq(h.live, 0);
}

Test(memory, many_rows)
{
    every_large(&VERBS[3], 3, 80);
}

Test(memory, many_variables)
{
    every_large(&VERBS[0], 17, 40);
}

/* Elimination is given up, and the projection walked around. */
Test(memory, polygon)
{
    every_large(&VERBS[1], 5, 18);
}

Test(memory, solver_new)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_options o = {.size = sizeof o};
    fmb_solver *const mark = (fmb_solver *)&h, *v = mark;
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        hook_arm(&h, k, false);
        st = fmb_solver_new(&o, &mem, &v);
        if (st != FMB_OK) {
            cr_assert_eq(st, FMB_ERR_MEMORY);
            cr_assert_eq(v, mark);
            cr_assert_eq(h.live, 0);
        }
    }
    fmb_solver_free(v);
    cr_assert_eq(h.live, 0);
}
