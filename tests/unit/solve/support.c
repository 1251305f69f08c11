/* support.c: projections by support queries against the ground truth, on systems whose projections
 * are flat, unbounded or without vertices, have many rows through one point, or wide numbers. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "unit/hull/shadows.h"

typedef struct family {
    const char *name;
    dense (*make)(support_rng *g);
    int count, strict; /* systems; strict rows, of 100 */
} family;

static fmb_solver *solver(fmb_evidence_kept evidence)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = evidence;
    o.method = FMB_METHOD_HULL;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

/* Some variables, and how many. */
static int choose_kept(support_rng *g, int dim, int *keep)
{
    int n = 0, most = support_between(g, 1, 4);
    for (int j = 0; j < dim && n < most; j++)
        if (support_chance(g, 50) || dim - j == most - n)
            keep[n++] = j;
    return n;
}

static void check_projection(const family *f, int seed, const fmb_system *s, support_rng *g)
{
    agree a = {.max_rows = 2000};
    truth t;
    int keep[6], n = choose_kept(g, fmb_system_dim(s), keep);
    fmb_solver *v = solver(FMB_EVIDENCE_ALL), *plain = solver(FMB_EVIDENCE_NONE);
    fmb_system *p = NULL, *q = NULL;
    fmb_result r = {.size = sizeof r};
    truth_init(&t, s, a.max_rows);
    cr_assert(agree_project(&a, v, &t, keep, n, &p), "%s %d: %s", f->name, seed, a.why);
    must(fmb_project(plain, s, keep, n, &q, &r));
    cr_assert(p && q && a.undecided == 0);
    cr_assert(r.stats.rounds == 0, "%s %d: variables were eliminated", f->name, seed);
    cr_assert(agree_same(&a, p, q), "%s %d: %s", f->name, seed, a.why);
    fmb_system_free(p);
    fmb_system_free(q);
    fmb_solver_free(v);
    fmb_solver_free(plain);
    truth_clear(&t);
}

/* Some rows become strict, in so many cases of 100. */
static void make_strict(dense *d, support_rng *g, int percent)
{
    for (int i = 0; i < d->rows; i++)
        if (d->rel[i] == FMB_LE && support_chance(g, percent))
            d->rel[i] = FMB_LT;
}

static void check_family(family f)
{
    for (int seed = 0; seed < f.count; seed++) {
        support_rng g = {(uint64_t)seed * 1000003 + 17};
        dense d = f.make(&g);
        make_strict(&d, &g, f.strict);
        fmb_system *s = dense_system(&d);
        check_projection(&f, seed, s, &g);
        fmb_system_free(s);
        dense_free(&d);
    }
}

Test(support, dense_rows)
{
    check_family((family){"dense rows", shadow_dense_rows, 20, 0});
}

Test(support, bounded)
{
    check_family((family){"bounded", shadow_bounded, 10, 0});
}

Test(support, through_a_point)
{
    check_family((family){"through a point", shadow_through_a_point, 20, 0});
}

Test(support, cones)
{
    check_family((family){"cone", shadow_cone, 20, 0});
}

Test(support, equalities)
{
    check_family((family){"with equalities", shadow_with_equalities, 20, 0});
}

Test(support, flat)
{
    check_family((family){"flat", shadow_flat, 20, 0});
}

Test(support, single_points)
{
    check_family((family){"single point", shadow_single_point, 13, 0});
}

Test(support, cubes_and_the_like)
{
    check_family((family){"cross-polytope", shadow_cross_polytope, 10, 0});
    check_family((family){"pyramid", shadow_pyramid, 10, 0});
}

Test(support, narrow)
{
    check_family((family){"narrow", shadow_narrow, 20, 0});
}

Test(support, unnamed)
{
    check_family((family){"unnamed", shadow_unnamed, 13, 0});
}

/* Many rows meet in one point, so faces of all dimensions may be missing. */
Test(support, strict_rows)
{
    for (int strict = 10; strict <= 90; strict += 40) {
        check_family((family){"bounded", shadow_bounded, 4, strict});
        check_family((family){"through a point", shadow_through_a_point, 15, strict});
        check_family((family){"cone", shadow_cone, 12, strict});
        check_family((family){"with equalities", shadow_with_equalities, 12, strict});
        check_family((family){"cross-polytope", shadow_cross_polytope, 5, strict});
        check_family((family){"pyramid", shadow_pyramid, 16, strict});
        check_family((family){"unnamed", shadow_unnamed, 12, strict});
    }
}

/* 0 <= x_j <= 1 in eight variables, and rows that cut the cube's corners. */
static fmb_system *cut_cube(void)
{
    support_rng g = {5};
    fmb_system *s = rows_none(8);
    for (int i = 0; i < 32; i++) {
        int64_t a[8] = {0}, b = i < 8;
        for (int j = 0; j < 8; j++)
            a[j] = i < 16 ? (j == i % 8) * (i < 8 ? 1 : -1) : support_between(&g, -5, 5);
        for (int j = 0; i >= 16 && j < 8; j++)
            b += a[j] > 0 ? a[j] : 0;
        must(fmb_system_add_int(s, a, FMB_LE, i < 16 ? b : b - support_between(&g, 1, 3)));
    }
    return s;
}

static size_t count_claims(const fmb_evidence *e, fmb_claim_kind kind)
{
    size_t count = 0;
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        count += fmb_evidence_kind(e, i) == kind;
    return count;
}

/* Cancels a solver after so many linear programs. */
typedef struct patience {
    fmb_solver *v;
    int programs;
} patience;

static void lose_patience(void *self, const fmb_event *event)
{
    patience *p = self;
    if (event->kind == FMB_EVENT_LP && --p->programs == 0)
        fmb_solver_cancel(p->v);
}

/* Cut short after so many programs: true of all that comes out; how many rows and points. */
static bool cut_short(const fmb_system *s, int programs, size_t *rows, size_t *points)
{
    static const int keep[] = {0, 1, 2};
    fmb_solver *v = solver(FMB_EVIDENCE_ALL);
    patience p = {v, programs};
    fmb_system *out = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    fmb_solver_set_sink(v, (fmb_sink){lose_patience, &p});
    must(fmb_project(v, s, keep, 3, &out, &r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted || fmb_evidence_claims(e) == 0, "claim %zu: %s", j.claim, j.reason);
    *rows = fmb_system_rows(out);
    *points = count_claims(e, FMB_CLAIM_FEASIBLE);
    cr_assert_geq(count_claims(e, FMB_CLAIM_IMPLIED), *rows);
    fmb_evidence_free(e);
    fmb_system_free(out);
    fmb_solver_free(v);
    return r.stop == FMB_STOP_CANCELLED;
}

/* At any time there are rows that are proved, and points. */
Test(support, cut_short)
{
    fmb_system *s = cut_cube();
    size_t rows = 0, points = 0, last = 0;
    int programs = 1;
    for (; cut_short(s, programs, &rows, &points); programs++) {
        cr_assert(programs < 12 || rows + points > (size_t)programs / 2, "%d: %zu, %zu", programs,
                  rows, points);
        last = rows > 0 ? points : last;
    }
    cr_expect(programs > 10 && last > 5 && points == 1, "%d, %zu", programs, last);
    fmb_system_free(s);
}

Test(support, wide)
{
    check_family((family){"wide", shadow_wide, 20, 0});
}

/* 30 dense rows over 11 variables: of seven that stay no way tells shortly. */
static fmb_system *dense_rows(void)
{
    support_rng g = {9};
    fmb_system *s = rows_none(11);
    for (int i = 0; i < 30; i++) {
        int64_t a[11];
        for (int j = 0; j < 11; j++)
            a[j] = support_between(&g, -9, 9);
        must(fmb_system_add_int(s, a, FMB_LE, 40));
    }
    return s;
}

/* An elimination comes to a limit while queries wait: what these have proved is handed out. */
Test(support, kept_where_an_elimination_is_cut_short)
{
    static const int keep[] = {0, 1, 2, 3, 4, 5, 6};
    fmb_options o = {.size = sizeof o};
    fmb_system *s = dense_rows(), *out = NULL;
    fmb_solver *v = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    o.evidence = FMB_EVIDENCE_ALL;
    o.max_rows = 300;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, s, keep, 7, &out, &r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted, "claim %zu: %s", j.claim, j.reason);
    cr_assert_eq(r.stop, FMB_STOP_ROWS);
    cr_assert_gt(count_claims(e, FMB_CLAIM_FEASIBLE), 1);
    fmb_evidence_free(e);
    fmb_system_free(out);
    fmb_solver_free(v);
    fmb_system_free(s);
}
