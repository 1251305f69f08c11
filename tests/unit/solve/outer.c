/* outer.c: the results of a query that a limit interrupts are proved, whenever this happens. */
#include <criterion/criterion.h>

#include "canceller.h"
#include "counted_clock.h"
#include "property/random/agree.h"
#include "support.h"

/* One way to be cut short. */
typedef struct cut {
    fmb_options o;
    canceller at;
} cut;

static cut make_cut(support_rng *g)
{
    static const fmb_method method[] = {FMB_METHOD_FM, FMB_METHOD_FM, FMB_METHOD_LP,
                                        FMB_METHOD_AUTO, FMB_METHOD_DD};
    cut c = {.o = (fmb_options){.size = sizeof(fmb_options)}, .at.events = -1};
    c.o.method = method[support_between(g, 0, 4)];
    c.o.evidence = FMB_EVIDENCE_ALL;
    c.o.arith = support_chance(g, 20) ? FMB_ARITH_GMP : FMB_ARITH_AUTO;
    c.o.rules = support_chance(g, 50) ? NULL : support_chance(g, 50) ? "none" : "kohler";
    c.o.presolve = support_chance(g, 20) ? "none" : NULL;
    switch (support_between(g, 0, 3)) {
    case 0:
        c.o.max_rows = (size_t)support_between(g, 1, 40);
        break;
    case 1:
        c.o.max_bytes = (size_t)support_between(g, 1000, 200000);
        break;
    case 2:
        c.o.max_seconds = support_between(g, 1, 50);
        break;
    default:
        c.at.events = support_between(g, 0, 40);
    }
    return c;
}

/* Time is counted from here on, to the end of the query. */
static void open_cut(cut *c)
{
    counted_clock_start(0, NULL, NULL);
    must(fmb_solver_new(&c->o, NULL, &c->at.v));
    if (c->at.events >= 0)
        fmb_solver_set_sink(c->at.v, (fmb_sink){cancel_at_event, &c->at});
}

/* Evidence is accepted; claims of that kind are counted. */
static size_t judge_claims(fmb_solver *v, const fmb_system *s, const fmb_result *r,
                           fmb_claim_kind kind)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    size_t found = 0;
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted || fmb_evidence_claims(e) == 0, "%s", j.reason);
    cr_assert(r->verdict == FMB_UNKNOWN || j.verdict == r->verdict, "%s", j.reason);
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        found += fmb_evidence_kind(e, i) == kind;
    fmb_evidence_free(e);
    return found;
}

/* ---- boxes ----------------------------------------------------------------------------------- */

/* Is the end as the truth, or beyond it if it is an outer one? */
static bool is_sound(const fmb_box *box, int i, fmb_side side, const study_textbook_end *known)
{
    fmb_end end = fmb_box_end(box, i, side);
    bool sound = end.kind == FMB_END_UNKNOWN || end.kind == known->kind;
    mpq_t q;
    mpq_init(q);
    if (end.kind == FMB_END_OUTER || end.kind == FMB_END_FINITE) {
        bool there = fmb_box_end_q(box, i, side, q);
        int order = mpq_cmp(q, known->value);
        bool beyond = side == FMB_LOWER ? order <= 0 : order >= 0;
        sound = there && known->kind == FMB_END_FINITE &&
                (end.kind == FMB_END_OUTER ? beyond && !end.attained : order == 0);
    }
    mpq_clear(q);
    return sound;
}

/* Number of ends that are outer. */
static size_t judge_box(const cut *c, const truth *t, const fmb_box *box, const fmb_result *r)
{
    size_t outer = 0;
    for (int i = 0; i < fmb_box_size(box); i++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
            fmb_end end = fmb_box_end(box, i, (fmb_side)side);
            outer += end.kind == FMB_END_OUTER;
            cr_assert(r->stop != FMB_STOP_DONE ||
                      (end.kind != FMB_END_OUTER && end.kind != FMB_END_UNKNOWN));
            if (t->end)
                cr_assert(is_sound(box, i, (fmb_side)side, &t->end[i][side]),
                          "x%d: kind %d, about %g, stop %s, method %d", i + 1, (int)end.kind,
                          end.value, fmb_stop_text(r->stop), (int)c->o.method);
        }
    cr_assert_eq(judge_claims(c->at.v, t->s, r, FMB_CLAIM_IMPLIED), outer);
    return outer;
}

static support_case make_system(support_rng *g)
{
    support_shape shape = {support_between(g, 1, 6), support_between(g, 1, 14),
                           support_chance(g, 15) ? 63 : 0};
    return support_make((support_family)support_between(g, 0, SUPPORT_FAMILIES - 1),
                        support_next(g), &shape);
}

typedef struct tally {
    int cut;
    size_t outer;
} tally;

static void bound(support_rng *g, const truth *t, tally *n)
{
    cut c = make_cut(g);
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    open_cut(&c);
    must(fmb_bound(c.at.v, t->s, NULL, 0, &box, &r));
    counted_clock_stop();
    cr_assert(r.verdict == FMB_UNKNOWN || r.verdict == t->verdict || t->verdict == FMB_UNKNOWN);
    cr_assert_eq(box == NULL, r.verdict == FMB_INFEASIBLE);
    n->cut += r.stop != FMB_STOP_DONE;
    if (box)
        n->outer += judge_box(&c, t, box, &r);
    else
        judge_claims(c.at.v, t->s, &r, FMB_CLAIM_INFEASIBLE);
    fmb_box_free(box);
    fmb_solver_free(c.at.v);
}

Test(outer, boxes)
{
    support_rng g = {2026};
    tally n = {0};
    for (int i = 0; i < 400 / WATCHED; i++) {
        support_case c = make_system(&g);
        truth t;
        truth_init(&t, c.s, 2000);
        for (int k = 0; k < 12; k++)
            bound(&g, &t, &n);
        truth_clear(&t);
        support_case_clear(&c);
    }
    cr_expect(n.cut > 250 / WATCHED && n.outer > 150 / WATCHED, "%d were cut short, %zu outer ends",
              n.cut, n.outer);
}

/* ---- projections ----------------------------------------------------------------------------- */

static void project(support_rng *g, const truth *t, tally *n)
{
    cut c = make_cut(g);
    agree judge = {.max_rows = 2000};
    fmb_system *p = NULL;
    fmb_result r = {.size = sizeof r};
    int keep[8], kept = 0;
    for (int j = 0; j < fmb_system_dim(t->s); j++)
        if (support_chance(g, 50))
            keep[kept++] = j;
    open_cut(&c);
    must(fmb_project(c.at.v, t->s, keep, kept, &p, &r));
    counted_clock_stop();
    cr_assert(p && fmb_system_dim(p) == kept);
    cr_assert(r.verdict == FMB_UNKNOWN || r.verdict == t->verdict || t->verdict == FMB_UNKNOWN);
    cr_assert(r.verdict == FMB_UNKNOWN ? r.stop != FMB_STOP_DONE : true);
    if (r.verdict != FMB_INFEASIBLE)
        cr_assert_geq(judge_claims(c.at.v, t->s, &r, FMB_CLAIM_IMPLIED), fmb_system_rows(p));
    cr_assert(agree_implies(&judge, t->s, p, keep), "%s", judge.why);
    n->cut += r.stop != FMB_STOP_DONE;
    n->outer += r.stop != FMB_STOP_DONE ? fmb_system_rows(p) : 0;
    fmb_system_free(p);
    fmb_solver_free(c.at.v);
}

Test(outer, projections)
{
    support_rng g = {1827};
    tally n = {0};
    for (int i = 0; i < 300 / WATCHED; i++) {
        support_case c = make_system(&g);
        truth t;
        truth_init(&t, c.s, 2000);
        for (int k = 0; k < 10; k++)
            project(&g, &t, &n);
        truth_clear(&t);
        support_case_clear(&c);
    }
    cr_expect(n.cut > 75 / WATCHED && n.outer > 150 / WATCHED, "%d were cut short, %zu rows", n.cut,
              n.outer);
}

/* ---- what is found --------------------------------------------------------------------------- */

/* Dense rows around 0, or a cone with (1 ... 1) inside: too many for the limits below. */
static fmb_system *dense(bool cone)
{
    enum { N = 8, M = 22 };
    support_rng g = {11};
    fmb_system *s = rows_none(N);
    for (int i = 0; i < M; i++) {
        int64_t a[N], sum = 0;
        for (int j = 0; j < N; j++)
            sum += a[j] = support_between(&g, -9, 9);
        a[i % N] -= cone && sum >= 0 ? sum + 1 : 0;
        must(fmb_system_add_int(s, a, FMB_LE, cone ? 0 : support_between(&g, 10, 60)));
    }
    return s;
}

/* Seconds of the counted clock that do not quite do: 15/16 of what the whole projection takes, but
 * for elimination, which would go on for minutes. */
static double most_of_time(const fmb_system *s, fmb_method method)
{
    cut c = {.o = (fmb_options){.size = sizeof(fmb_options)}, .at.events = -1};
    fmb_system *p = NULL;
    fmb_result r = {.size = sizeof r};
    if (method == FMB_METHOD_FM)
        return 2000;
    c.o.method = method;
    c.o.evidence = FMB_EVIDENCE_ALL;
    c.o.max_seconds = COUNTED_FOREVER;
    open_cut(&c);
    must(fmb_project(c.at.v, s, (int[]){0, 1}, 2, &p, &r));
    counted_clock_stop();
    cr_assert_eq(r.stop, FMB_STOP_DONE);
    fmb_system_free(p);
    fmb_solver_free(c.at.v);
    return (double)(counted_clock_readings() - counted_clock_readings() / 16);
}

/* Whatever the way and the limit, there are rows around the projection and points of it; a limit of
 * time is reached, and must leave some for the first of them. */
Test(outer, rows_and_points_by_every_way)
{
    static const fmb_method method[] = {FMB_METHOD_FM, FMB_METHOD_DD, FMB_METHOD_HULL};
    fmb_system *s = dense(false);
    for (int k = 0; k < 9; k++) {
        cut c = {.o = (fmb_options){.size = sizeof(fmb_options)}, .at.events = -1};
        fmb_system *p = NULL;
        fmb_result r = {.size = sizeof r};
        c.o.method = method[k / 3];
        c.o.evidence = FMB_EVIDENCE_ALL;
        c.o.max_rows = k % 3 == 0 ? 25 : 0;
        c.o.max_bytes = k % 3 == 1 ? 300000 : 0;
        c.o.max_seconds = k % 3 == 2 ? most_of_time(s, method[k / 3]) : 0;
        open_cut(&c);
        must(fmb_project(c.at.v, s, (int[]){0, 1}, 2, &p, &r));
        counted_clock_stop();
        cr_expect(k % 3 != 2 || r.stop == FMB_STOP_TIME, "way %d: %s", k, fmb_stop_text(r.stop));
        cr_expect(fmb_system_rows(p) > 0, "way %d: no row", k);
        cr_expect(r.stop == FMB_STOP_DONE || judge_claims(c.at.v, s, &r, FMB_CLAIM_FEASIBLE) > 1,
                  "way %d: no points", k);
        cr_expect_geq(judge_claims(c.at.v, s, &r, FMB_CLAIM_IMPLIED), fmb_system_rows(p));
        fmb_system_free(p);
        fmb_solver_free(c.at.v);
    }
    fmb_system_free(s);
}

/* x in [1, 5), y <= x - 2, z = 2 y + 1 and more rows about others than the limit allows. */
static fmb_system *chain(void)
{
    static const int64_t row[][4] = {{-1, 0, 0, -1}, {1, 0, 0, 5},  {-1, 1, 0, -2},
                                     {0, -2, 1, 1},  {1, 1, 1, 90}, {-1, -1, -1, 90}};
    static const fmb_rel rel[] = {FMB_LE, FMB_LT, FMB_LE, FMB_EQ, FMB_LE, FMB_LE};
    fmb_system *s = rows_none(3);
    for (int i = 0; i < 6; i++)
        must(fmb_system_add_int(s, row[i], rel[i], row[i][3]));
    return s;
}

Test(outer, chain)
{
    fmb_system *s = chain();
    cut c = {.o = (fmb_options){.size = sizeof(fmb_options)}, .at.events = 1};
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    c.o.evidence = FMB_EVIDENCE_ALL;
    open_cut(&c);
    must(fmb_bound(c.at.v, s, NULL, 0, &box, &r));
    counted_clock_stop();
    cr_assert(box && r.stop == FMB_STOP_CANCELLED && r.verdict == FMB_UNKNOWN);
    fmb_end x = fmb_box_end(box, 0, FMB_LOWER), y = fmb_box_end(box, 1, FMB_UPPER),
            z = fmb_box_end(box, 2, FMB_UPPER);
    cr_expect(x.kind == FMB_END_OUTER && x.value >= 1 && x.value <= 1 && !x.attained);
    cr_expect(y.kind == FMB_END_OUTER && y.value >= 3 && y.value <= 3);
    cr_expect(z.kind == FMB_END_OUTER && z.value >= 7 && z.value <= 7);
    cr_expect_geq(judge_claims(c.at.v, s, &r, FMB_CLAIM_IMPLIED), 4);
    fmb_box_free(box);
    fmb_solver_free(c.at.v);
    fmb_system_free(s);
}

/* Ends that contradict each other are an answer, whatever the limit. */
Test(outer, contradiction)
{
    fmb_system *s = chain();
    cut c = {.o = (fmb_options){.size = sizeof(fmb_options)}, .at.events = 1};
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_system_add_int(s, (int64_t[]){0, 0, -1}, FMB_LE, -7));
    c.o.evidence = FMB_EVIDENCE_ALL;
    open_cut(&c);
    must(fmb_bound(c.at.v, s, NULL, 0, &box, &r));
    counted_clock_stop();
    cr_assert_null(box);
    cr_assert(r.verdict == FMB_INFEASIBLE && r.stop == FMB_STOP_DONE);
    cr_expect_eq(judge_claims(c.at.v, s, &r, FMB_CLAIM_INFEASIBLE), 1);
    fmb_solver_free(c.at.v);
    fmb_system_free(s);
}

/* Of a cone, which has one vertex, rays lead to points. */
Test(outer, points_of_a_cone)
{
    static const fmb_method method[] = {FMB_METHOD_FM, FMB_METHOD_DD};
    fmb_system *s = dense(true);
    for (int k = 0; k < 2; k++) {
        cut c = {.o = (fmb_options){.size = sizeof(fmb_options)}, .at.events = -1};
        fmb_system *p = NULL;
        fmb_result r = {.size = sizeof r};
        c.o.method = method[k];
        c.o.evidence = FMB_EVIDENCE_ALL;
        c.o.max_rows = 25;
        open_cut(&c);
        must(fmb_project(c.at.v, s, (int[]){0, 1, 2, 3}, 4, &p, &r));
        counted_clock_stop();
        cr_expect_eq(r.stop, FMB_STOP_ROWS);
        cr_expect_gt(judge_claims(c.at.v, s, &r, FMB_CLAIM_FEASIBLE), 3, "way %d", k);
        fmb_system_free(p);
        fmb_solver_free(c.at.v);
    }
    fmb_system_free(s);
}
