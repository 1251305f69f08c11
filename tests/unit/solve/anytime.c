/* anytime.c: an interrupted projection gives an outer bound at once, and more time never enlarges
 * it. */
#include <criterion/criterion.h>

#include "counted_clock.h"
#include "property/random/agree.h"
#include "support.h"

enum { N = 6, M = WATCHED == 1 ? 15 : 11, KEPT = 3, BOUNDS = 2 * KEPT + 1 };

/* Dense rows around 0, behind rows that name variables that stay: a box, and one of two of them. */
static fmb_system *boxed_rows(void)
{
    support_rng g = {11};
    fmb_system *s = rows_none(N);
    for (int i = 0; i < 2 * KEPT; i++) {
        int64_t a[N] = {0};
        a[i / 2] = i % 2 ? -1 : 1;
        must(fmb_system_add_int(s, a, FMB_LE, 1000));
    }
    must(fmb_system_add_int(s, (int64_t[N]){1, -1}, FMB_LE, 1500));
    for (int i = 0; i < M; i++) {
        int64_t a[N];
        for (int j = 0; j < N; j++)
            a[j] = support_between(&g, -9, 9);
        must(fmb_system_add_int(s, a, FMB_LE, support_between(&g, 10, 60)));
    }
    return s;
}

/* Every row is proved. */
static void judge_rows(fmb_solver *v, const fmb_system *s, const fmb_system *p)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    agree judge = {.max_rows = 2000};
    size_t implied = 0;
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted || fmb_evidence_claims(e) == 0, "%s", j.reason);
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        implied += fmb_evidence_kind(e, i) == FMB_CLAIM_IMPLIED;
    cr_assert_geq(implied, fmb_system_rows(p));
    cr_assert(agree_implies(&judge, s, p, (int[]){0, 1, 2}), "%s", judge.why);
    fmb_evidence_free(e);
}

static fmb_system *project(const fmb_system *s, fmb_options o, fmb_result *r)
{
    fmb_solver *v = NULL;
    fmb_system *p = NULL;
    o.size = sizeof o;
    counted_clock_start(0, NULL, NULL);
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, s, (int[]){0, 1, 2}, KEPT, &p, r));
    counted_clock_stop();
    if (r->stop != FMB_STOP_DONE) {
        judge_rows(v, s, p);
        cr_assert_geq(fmb_system_rows(p), BOUNDS, "%zu rows", fmb_system_rows(p));
    }
    fmb_solver_free(v);
    return p;
}

static const fmb_method METHOD[] = {FMB_METHOD_HULL, FMB_METHOD_DD, FMB_METHOD_AUTO, FMB_METHOD_FM};

/* Looser and looser limits of readings of the clock, until it is done. The first two ways are
 * always the same: each answer lies in those before. */
static int loosen_time(const fmb_system *s, int way)
{
    agree judge = {.max_rows = 2000};
    fmb_result r = {.size = sizeof r};
    fmb_system *before = project(s, (fmb_options){.method = METHOD[way], .max_seconds = 3}, &r);
    int cut = 0;
    for (double limit = 4; limit < 3000 && r.stop != FMB_STOP_DONE;
         limit *= WATCHED == 1 ? 1.6 : 2.56, cut++) {
        fmb_system *p = project(s, (fmb_options){.method = METHOD[way], .max_seconds = limit}, &r);
        cr_assert(way > 1 || agree_implies(&judge, p, before, (int[]){0, 1, 2}), "way %d, %g s: %s",
                  way, limit, judge.why);
        fmb_system_free(before);
        before = p;
    }
    fmb_system_free(before);
    return cut;
}

Test(anytime, more_time_makes_it_smaller)
{
    fmb_system *s = boxed_rows();
    for (int way = 0; way < 4; way++)
        cr_expect_gt(loosen_time(s, way), WATCHED == 1 ? 5 : 2, "way %d", way);
    fmb_system_free(s);
}

/* Nor do limits of memory and of rows take bounds away. */
Test(anytime, bounds_under_every_limit)
{
    fmb_system *s = boxed_rows();
    for (int way = 0; way < 4; way++) {
        for (size_t rows = 1; rows < 1000; rows *= 4 * WATCHED) {
            fmb_result r = {.size = sizeof r};
            fmb_system_free(project(s, (fmb_options){.method = METHOD[way], .max_rows = rows}, &r));
        }
        for (size_t bytes = 1 << 16; bytes < 1 << 20; bytes *= 4 * WATCHED) {
            fmb_result r = {.size = sizeof r};
            fmb_system_free(
                project(s, (fmb_options){.method = METHOD[way], .max_bytes = bytes}, &r));
        }
    }
    fmb_system_free(s);
}
