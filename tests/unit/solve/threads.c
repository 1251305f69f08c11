/* threads.c: the ends of a box by several threads are those by one, and proved; under limits too.
 */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "support.h"

enum { DIM = 60 };

/* [give] Rows of four terms around a point, some strict; some variables have no upper end. */
static fmb_system *large(support_rng *g)
{
    fmb_system *s = rows_none(DIM);
    for (int i = 0; i < 2 * DIM; i++) {
        int64_t a[DIM] = {0}, at_point = 0;
        for (int k = 0; k < 4; k++)
            a[support_between(g, 0, DIM - 1)] = support_between(g, -5, 5);
        for (int j = 0; j < DIM; j++)
            at_point += a[j] * (j % 7);
        must(fmb_system_add_int(s, a, support_chance(g, 10) ? FMB_LT : FMB_LE,
                                at_point + support_between(g, 1, 9)));
    }
    for (int j = 0; j < DIM; j++) {
        int64_t a[DIM] = {0};
        a[j] = support_chance(g, 90) ? -1 : 1;
        must(fmb_system_add_int(s, a, FMB_LE, 1000));
    }
    return s;
}

static fmb_box *box_by(const fmb_system *s, size_t threads, double seconds, fmb_result *r)
{
    fmb_options o = fmb_options_default();
    fmb_solver *v = NULL;
    fmb_box *box = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j;
    o.threads = threads;
    o.max_seconds = seconds;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_bound(v, s, NULL, 0, &box, r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_expect(j.accepted || r->stop != FMB_STOP_DONE, "%s", j.reason);
    fmb_evidence_free(e);
    fmb_solver_free(v);
    return box;
}

static void expect_same_box(const fmb_box *a, const fmb_box *b)
{
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    for (int i = 0; i < DIM; i++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
            fmb_end p = fmb_box_end(a, i, (fmb_side)side), q = fmb_box_end(b, i, (fmb_side)side);
            cr_expect(p.kind == q.kind && p.attained == q.attained);
            fmb_box_end_q(a, i, (fmb_side)side, x);
            fmb_box_end_q(b, i, (fmb_side)side, y);
            cr_expect(mpq_equal(x, y));
        }
    mpq_clears(x, y, NULL);
}

Test(threads, same_box)
{
    support_rng g = {77};
    for (int i = 0; i < 4; i++) {
        fmb_result r;
        fmb_system *s = large(&g);
        fmb_box *one = box_by(s, 0, 0, &r);
        cr_assert(one && r.stop == FMB_STOP_DONE);
        for (size_t threads = 2; threads <= 5; threads += 3) {
            fmb_box *several = box_by(s, threads, 0, &r);
            cr_assert(several && r.stop == FMB_STOP_DONE && r.stats.lps > 0);
            expect_same_box(one, several);
            fmb_box_free(several);
        }
        fmb_box_free(one);
        fmb_system_free(s);
    }
}

/* Whatever is known when time is up is right. */
Test(threads, limits)
{
    support_rng g = {78};
    fmb_system *s = large(&g);
    fmb_result r;
    fmb_box *one = box_by(s, 1, 0, &r);
    for (int i = 0; i < 8; i++) {
        fmb_box *some = box_by(s, 3, 0.002 * (i + 1), &r);
        for (int j = 0; some && j < DIM; j++)
            for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
                fmb_end p = fmb_box_end(some, j, (fmb_side)side),
                        q = fmb_box_end(one, j, (fmb_side)side);
                cr_expect(p.kind == FMB_END_UNKNOWN || p.kind == FMB_END_OUTER ||
                          (p.kind == q.kind && p.value <= q.value && p.value >= q.value));
            }
        fmb_box_free(some);
    }
    fmb_box_free(one);
    fmb_system_free(s);
}
