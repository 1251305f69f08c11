/* preimages.c: see preimages.h. */
#include "preimages.h"

#include <criterion/criterion.h>

#include "property/random/rows.h"

fmb_solver *lifts_solver(void)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

static lifts_answer judge(fmb_solver *v, lifts_answer a, const fmb_result *r)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    a.verdict = r->verdict;
    cr_assert(a.lift && a.out && r->stop == FMB_STOP_DONE);
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(a.lift, e, &j));
    cr_assert(j.accepted, "%s", j.reason);
    cr_assert_gt(fmb_evidence_claims(e), 0);
    fmb_evidence_free(e);
    return a;
}

lifts_answer lifts_image(fmb_solver *v, const fmb_system *s, const fmb_system *graph)
{
    lifts_answer a = {NULL, NULL, FMB_UNKNOWN};
    fmb_result r = {.size = sizeof r};
    must(fmb_image(v, s, graph, &a.lift, &a.out, &r));
    return judge(v, a, &r);
}

lifts_answer lifts_sum(fmb_solver *v, const fmb_system *const *s, size_t n)
{
    lifts_answer a = {NULL, NULL, FMB_UNKNOWN};
    fmb_result r = {.size = sizeof r};
    must(fmb_sum(v, s, n, &a.lift, &a.out, &r));
    return judge(v, a, &r);
}

lifts_answer lifts_hull(fmb_solver *v, const fmb_system *const *s, size_t n)
{
    lifts_answer a = {NULL, NULL, FMB_UNKNOWN};
    fmb_result r = {.size = sizeof r};
    must(fmb_hull_union(v, s, n, &a.lift, &a.out, &r));
    return judge(v, a, &r);
}

void lifts_clear(lifts_answer *a)
{
    fmb_system_free(a->lift);
    fmb_system_free(a->out);
    *a = (lifts_answer){NULL, NULL, FMB_UNKNOWN};
}
