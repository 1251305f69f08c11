/* memory.c: the k-th allocation fails, for the first k and many later ones: an error status,
 * outputs untouched, no leak, and the next call succeeds. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>

#include "bodies.h"
#include "fault/hook.h"
#include "property/random/rows.h"

enum { VERBS = 5 };

/* True if the call worked. */
static bool ask(int verb, fmb_solver *v, const fmb_frame *f)
{
    static const fmb_result fresh = {.size = sizeof fresh};
    fmb_proximity *const mark = (fmb_proximity *)v, *p = mark;
    fmb_generators *const points = (fmb_generators *)v, *common = points;
    fmb_system *const none = (fmb_system *)v, *row = none;
    fmb_result r = {.size = sizeof r};
    fmb_status st = verb == 0   ? fmb_distance(v, f, FMB_NORM_EUCLIDEAN, &p, &r)
                    : verb == 1 ? fmb_distance(v, f, FMB_NORM_MAX, &p, &r)
                    : verb == 2 ? fmb_depth(v, f, FMB_NORM_EUCLIDEAN, &p, &r)
                    : verb == 3 ? fmb_separate(v, f, FMB_CONTACT_CLOSED, &row, &r)
                                : fmb_common(v, f, &common, &r);
    if (st != FMB_OK) {
        cr_assert(st == FMB_ERR_MEMORY && p == mark && common == points && row == none);
        cr_assert_eq(memcmp(&r, &fresh, sizeof r), 0, "the result was touched");
        return false;
    }
    fmb_proximity_free(p == mark ? NULL : p);
    fmb_generators_free(common == points ? NULL : common);
    fmb_system_free(row == none ? NULL : row);
    return true;
}

static void fail_each(int verb, const fmb_frame *f)
{
    bool done = false;
    for (size_t k = 1; !done; k += 1 + k / 32) {
        hook h = {0};
        fmb_alloc mem = hook_alloc(&h);
        fmb_solver *v = NULL;
        hook_arm(&h, k, false);
        if (fmb_solver_new(NULL, &mem, &v) == FMB_OK) {
            done = ask(verb, v, f) && h.calls < k;
            hook_calm(&h);
            cr_assert(ask(verb, v, f));
        }
        fmb_solver_free(v);
        cr_assert_eq(h.live, 0);
    }
}

Test(proximity_memory, allocations_fail_once)
{
    support_rng g = {31};
    for (int round = 0; round < 2; round++) {
        bodies b;
        bodies_draw(&g, 2, round == 0, 4, &b);
        for (int verb = 0; verb < VERBS; verb++)
            fail_each(verb, b.f);
    }
}
