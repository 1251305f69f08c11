/* optima_limits.c: the optimum of a linear form when a limit ends the query: the returned bounds
 * are proved, and improve with the limit. */
#include <criterion/criterion.h>

#include <fmb/fmb.h>

#include "canceller.h"
#include "counted_clock.h"
#include "property/random/rows.h"
#include "support.h"

typedef struct tally {
    int cut, outer, exact;
} tally;

/* What the whole query says: of no solution anything holds. */
typedef enum whole_end { NO_END, AN_END, NO_SOLUTION } whole_end;

/* However a query is cut short, what it says is proved: no solution is beyond an outer end. */
static void judge_cut(fmb_solver *v, const fmb_system *s, const fmb_optimum *o, const fmb_result *r,
                      const mpq_t best, whole_end whole, tally *n)
{
    fmb_end end = fmb_optimum_end(o);
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    mpq_t q;
    mpq_init(q);
    n->cut += r->stop != FMB_STOP_DONE;
    if (fmb_optimum_value_q(o, q)) {
        int order = mpq_cmp(q, best);
        cr_assert_neq(whole, NO_END, "an end where there is none");
        cr_assert(whole == NO_SOLUTION || (end.kind == FMB_END_OUTER ? order >= 0 : order == 0),
                  "kind %d, about %g", (int)end.kind, end.value);
        *(end.kind == FMB_END_OUTER ? &n->outer : &n->exact) += 1;
    }
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted || fmb_evidence_claims(e) == 0, "%s", j.reason);
    bool implied = false;
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        implied = implied || fmb_evidence_kind(e, i) == FMB_CLAIM_IMPLIED;
    cr_assert_eq(implied, end.kind == FMB_END_OUTER);
    fmb_evidence_free(e);
    mpq_clear(q);
}

static fmb_optimum *optimum_of(fmb_solver *v, const fmb_system *s, fmb_result *r)
{
    double coef[6] = {1, 2, -1, 1, 3, -2};
    fmb_optimum *o = NULL;
    must(fmb_optimize(v, s, &(fmb_objective){FMB_SENSE_MAX, coef, 0}, &o, r));
    return o;
}

static void cut_often(support_rng *g, const fmb_system *s, const mpq_t best, whole_end whole,
                      tally *n)
{
    static const fmb_method methods[] = {FMB_METHOD_AUTO, FMB_METHOD_FM, FMB_METHOD_LP};
    for (int k = 0; k < 10; k++) {
        fmb_options o = {.size = sizeof o};
        canceller c = {.events = support_between(g, 0, 30)};
        fmb_result r = {.size = sizeof r};
        o.evidence = FMB_EVIDENCE_ALL;
        o.method = methods[support_between(g, 0, 2)];
        if (k % 3 == 0)
            o.max_rows = (size_t)support_between(g, 1, 40);
        else if (k % 3 == 1)
            o.max_bytes = (size_t)support_between(g, 1000, 100000);
        must(fmb_solver_new(&o, NULL, &c.v));
        if (k % 3 == 2)
            fmb_solver_set_sink(c.v, (fmb_sink){cancel_at_event, &c});
        fmb_optimum *found = optimum_of(c.v, s, &r);
        if (found)
            judge_cut(c.v, s, found, &r, best, whole, n);
        fmb_optimum_free(found);
        fmb_solver_free(c.v);
    }
}

Test(optima_limits, random_ones)
{
    support_rng g = {77};
    tally n = {0};
    fmb_solver *v = must_open((fmb_options){.evidence = FMB_EVIDENCE_NONE});
    mpq_t best;
    mpq_init(best);
    for (int i = 0; i < 300 / WATCHED; i++) {
        support_shape shape = {support_between(&g, 1, 6), support_between(&g, 3, 14), 0};
        support_case c = support_make((support_family)support_between(&g, 0, SUPPORT_FAMILIES - 1),
                                      support_next(&g), &shape);
        fmb_result r = {.size = sizeof r};
        fmb_optimum *o = optimum_of(v, c.s, &r);
        whole_end whole = !o ? NO_SOLUTION : fmb_optimum_value_q(o, best) ? AN_END : NO_END;
        cut_often(&g, c.s, best, whole, &n);
        fmb_optimum_free(o);
        support_case_clear(&c);
    }
    cr_expect(n.cut > 300 / WATCHED && n.outer > 10 / WATCHED && n.exact > 100 / WATCHED,
              "%d cut, %d outer, %d exact", n.cut, n.outer, n.exact);
    mpq_clear(best);
    fmb_solver_free(v);
}

/* A program whose optimum takes some pivots, from a corner far away. */
static fmb_system *many_rows(support_rng *g, int strict)
{
    enum { DIM = 12, ROWS = 40 };
    fmb_system *s = rows_none(DIM);
    for (int i = 0; i < ROWS; i++) {
        int64_t a[DIM];
        for (int j = 0; j < DIM; j++)
            a[j] = support_between(g, 0, 99);
        must(fmb_system_add_int(s, a, support_chance(g, strict) ? FMB_LT : FMB_LE, 1000));
    }
    for (int j = 0; j < DIM; j++) {
        int64_t a[DIM] = {0};
        a[j] = -1;
        must(fmb_system_add_int(s, a, FMB_LE, -1));
    }
    return s;
}

/* How much is reached by so many readings of the clock, with what proves it; true: it is all. */
static bool reach_within(const fmb_system *s, size_t readings, mpq_t reached)
{
    fmb_options how = {.size = sizeof how, .method = FMB_METHOD_LP};
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    fmb_optimum *o = NULL;
    double coef[12];
    mpq_t x, c;
    mpq_inits(x, c, NULL);
    for (int j = 0; j < 12; j++)
        coef[j] = 1 + j;
    how.max_seconds = (double)readings;
    must(fmb_solver_new(&how, NULL, &v));
    counted_clock_start(0, NULL, NULL);
    must(fmb_optimize(v, s, &(fmb_objective){FMB_SENSE_MAX, coef, 0}, &o, &r));
    counted_clock_stop();
    mpq_set_ui(reached, 0, 1);
    for (int j = 0; r.verdict == FMB_FEASIBLE && j < 12; j++) {
        fmb_optimum_coordinate_q(o, j, x);
        mpq_set_d(c, coef[j]);
        mpq_mul(x, x, c);
        mpq_add(reached, reached, x);
    }
    fmb_evidence *e = NULL;
    fmb_judgement judged = {.size = sizeof judged};
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &judged));
    cr_assert(judged.accepted || fmb_evidence_claims(e) == 0, "%s", judged.reason);
    size_t last = fmb_evidence_claims(e); /* with a FEASIBLE claim for the point */
    for (int j = 0; r.stop != FMB_STOP_DONE && r.verdict == FMB_FEASIBLE && j < 12; j++) {
        size_t i = last;
        while (i-- > 0 && fmb_evidence_kind(e, i) != FMB_CLAIM_FEASIBLE)
            continue;
        fmb_evidence_coordinate_q(e, i, j, x);
        fmb_optimum_coordinate_q(o, j, c);
        cr_assert(mpq_equal(x, c), "the point is not claimed");
    }
    fmb_evidence_free(e);
    fmb_optimum_free(o);
    fmb_solver_free(v);
    mpq_clears(x, c, NULL);
    return r.stop == FMB_STOP_DONE;
}

/* The longer it takes, the more is reached; and a limit that comes between the first solution and
 * the optimum tells a point that is better than the first. */
Test(optima_limits, a_limit_tells_the_best_point_so_far)
{
    support_rng g = {5};
    int better = 0;
    mpq_t reached, before;
    mpq_inits(reached, before, NULL);
    for (int i = 0; i < 8; i++) {
        fmb_system *s = many_rows(&g, i % 2 ? 20 : 0);
        int steps = 0;
        bool all = false;
        mpq_set_ui(before, 0, 1);
        for (size_t k = 1; !all; k++) {
            all = reach_within(s, k, reached);
            cr_assert(all || mpq_cmp(reached, before) >= 0, "less by the limit %zu", k);
            steps += !all && mpq_sgn(before) > 0 && mpq_cmp(reached, before) > 0;
            mpq_set(before, reached);
        }
        better += steps > 0;
        fmb_system_free(s);
    }
    cr_expect_geq(better, 6, "%d of 8", better);
    mpq_clears(reached, before, NULL);
}
