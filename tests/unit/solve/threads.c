/* threads.c: several threads find the same ends of a box, irredundant rows and rows of a projection
 * as one, and proofs; under limits too; and vertices and hulls in the same order. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <fmb/generators.h>

#include "counted_clock.h"
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

/* Limits are in readings of a counted clock; 0: none. */
static fmb_box *box_by(const fmb_system *s, size_t threads, size_t seconds, fmb_result *r)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_box *box = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    o.threads = threads;
    o.max_seconds = seconds > 0 ? (double)seconds : COUNTED_FOREVER;
    must(fmb_solver_new(&o, NULL, &v));
    counted_clock_start(0, NULL, NULL);
    must(fmb_bound(v, s, NULL, 0, &box, r));
    counted_clock_stop();
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
    for (int i = 0; i < (3 + WATCHED) / WATCHED; i++) {
        fmb_result r = {.size = sizeof r};
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
    fmb_result r = {.size = sizeof r};
    fmb_box *one = box_by(s, 3, 0, &r);
    size_t all = counted_clock_readings();
    for (size_t i = 1; i < 8; i++) {
        fmb_box *some = box_by(s, 3, all * i / 8, &r);
        cr_expect_eq(r.stop, FMB_STOP_TIME, "%zu: %s", i, fmb_stop_text(r.stop));
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

/* ---- rows that stay -------------------------------------------------------------------------- */

enum { MANY = 2500 };

/* [give] Rows around a ball, some of them farther away, some twice. */
static fmb_system *around_ball(support_rng *g)
{
    fmb_system *s = rows_none(3);
    int64_t a[3] = {1, 0, 0}, right = 0;
    for (int i = 0; i < MANY; i++) {
        double square = 0;
        for (int j = 0; j < 3 && (i == 0 || support_chance(g, 95)); j++)
            a[j] = support_between(g, -500, 500);
        for (int j = 0; j < 3; j++)
            square += (double)(a[j] * a[j]);
        right = (int64_t)(1000 * sqrt(square)) + support_between(g, 0, 40) * 1000 + 1;
        must(fmb_system_add_int(s, a, support_chance(g, 10) ? FMB_LT : FMB_LE, right));
    }
    return s;
}

/* [give] The proof, as text. */
static char *reduce_by(const fmb_system *s, size_t threads, fmb_stop stop, size_t seconds,
                       fmb_fate *fate)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_evidence *e = NULL;
    fmb_system *reduced = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    o.threads = threads;
    o.max_seconds = seconds > 0 ? (double)seconds : COUNTED_FOREVER;
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    counted_clock_start(0, NULL, NULL);
    must(fmb_reduce(v, s, fate, &reduced, &r));
    counted_clock_stop();
    must(fmb_solver_evidence(v, &e));
    cr_expect_eq(stop, r.stop, "%s", fmb_stop_text(r.stop));
    must(fmb_check(s, e, &j));
    cr_expect(j.accepted || (r.stop != FMB_STOP_DONE && fmb_evidence_claims(e) == 0), "%s",
              j.reason);
    must(fmb_evidence_write(e, s, f));
    fclose(f);
    fmb_evidence_free(e);
    fmb_system_free(reduced);
    fmb_solver_free(v);
    return text;
}

Test(threads, same_rows_stay)
{
    support_rng g = {79};
    fmb_system *s = around_ball(&g);
    fmb_fate one[MANY], two[MANY], five[MANY];
    char *alone = reduce_by(s, 1, FMB_STOP_DONE, 0, one);
    char *by_two = reduce_by(s, 2, FMB_STOP_DONE, 0, two);
    char *by_five = reduce_by(s, 5, FMB_STOP_DONE, 0, five);
    for (int i = 0; i < MANY; i++)
        cr_assert(one[i] != FMB_FATE_UNKNOWN && one[i] == two[i] && one[i] == five[i], "row %d", i);
    cr_expect_str_eq(by_two, by_five);
    free(alone);
    free(by_two);
    free(by_five);
    fmb_system_free(s);
}

/* What is known when time is up is proved. */
Test(threads, rows_under_a_limit)
{
    support_rng g = {80};
    fmb_system *s = around_ball(&g);
    fmb_fate whole[MANY], some[MANY];
    free(reduce_by(s, 3, FMB_STOP_DONE, 0, whole));
    size_t all = counted_clock_readings();
    for (size_t k = 1; k <= 3; k++) {
        free(reduce_by(s, 3, FMB_STOP_TIME, all * k / 4, some));
        for (int i = 0; i < MANY; i++)
            cr_expect(some[i] == FMB_FATE_UNKNOWN || some[i] == whole[i], "row %d", i);
    }
    fmb_system_free(s);
}

/* ---- projections ----------------------------------------------------------------------------- */

enum { LIFTED = 8, KEPT = 4 };

/* [give] Rows around the origin, so many of 100 strict; in some directions it may go on for ever.
 */
static fmb_system *around_origin(support_rng *g, int strict)
{
    fmb_system *s = rows_none(LIFTED);
    for (int i = 0; i < 4 * LIFTED; i++) {
        int64_t a[LIFTED];
        for (int j = 0; j < LIFTED; j++)
            a[j] = support_between(g, -9, 9);
        must(fmb_system_add_int(s, a, support_chance(g, strict) ? FMB_LT : FMB_LE,
                                support_between(g, 10, 99)));
    }
    return s;
}

/* [give] The projection, and its proof as text. */
static fmb_system *project_by(const fmb_system *s, fmb_method method, size_t threads,
                              size_t seconds, fmb_stop *stop, char **proof)
{
    static const int keep[KEPT] = {0, 2, 3, 5};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_evidence *e = NULL;
    fmb_system *p = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    size_t size = 0;
    FILE *f = open_memstream(proof, &size);
    o.threads = threads;
    o.max_seconds = seconds > 0 ? (double)seconds : COUNTED_FOREVER;
    o.method = method;
    must(fmb_solver_new(&o, NULL, &v));
    counted_clock_start(0, NULL, NULL);
    must(fmb_project(v, s, keep, KEPT, &p, &r));
    counted_clock_stop();
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_expect(j.accepted || (r.stop != FMB_STOP_DONE && fmb_evidence_claims(e) == 0), "%s",
              j.reason);
    must(fmb_evidence_write(e, s, f));
    fclose(f);
    *stop = r.stop;
    fmb_evidence_free(e);
    fmb_solver_free(v);
    return p;
}

static void expect_same_rows(const fmb_system *a, const fmb_system *b)
{
    char *text[2] = {NULL, NULL};
    size_t size;
    for (int i = 0; i < 2; i++) {
        FILE *f = open_memstream(&text[i], &size);
        must(fmb_system_write(i == 0 ? a : b, FMB_FORMAT_TEXT, f));
        fclose(f);
    }
    cr_expect_str_eq(text[0], text[1]);
    free(text[0]);
    free(text[1]);
}

Test(threads, same_projection)
{
    support_rng g = {81};
    for (int i = 0; i < 4; i++) {
        fmb_method method = i % 2 == 0 ? FMB_METHOD_HULL : FMB_METHOD_DD;
        fmb_system *s = around_origin(&g, method == FMB_METHOD_DD ? 0 : 5), *p[3];
        char *proof[3];
        fmb_stop stop;
        for (int k = 0; k < 3; k++) {
            p[k] = project_by(s, method, (size_t[]){1, 2, 5}[k], 0, &stop, &proof[k]);
            cr_assert(p[k] && stop == FMB_STOP_DONE && fmb_system_rows(p[k]) > 40);
            expect_same_rows(p[0], p[k]);
        }
        cr_expect_str_eq(proof[1], proof[2]);
        if (method == FMB_METHOD_DD)
            cr_expect_str_eq(proof[0], proof[1]);
        for (int k = 0; k < 3; k++) {
            fmb_system_free(p[k]);
            free(proof[k]);
        }
        fmb_system_free(s);
    }
}

/* [give] The distances between POINTS points: the metric cone, in a box. */
static fmb_system *metric_cone(void)
{
    enum { POINTS = 6, PAIRS = POINTS * (POINTS - 1) / 2 };
    int pair[POINTS][POINTS], pairs = 0;
    for (int i = 0; i < POINTS; i++)
        for (int j = i + 1; j < POINTS; j++)
            pair[i][j] = pair[j][i] = pairs++;
    fmb_system *s = rows_none(PAIRS);
    for (int i = 0; i < POINTS; i++)
        for (int j = i + 1; j < POINTS; j++) {
            int64_t most[PAIRS] = {0};
            for (int k = 0; k < POINTS; k++) {
                int64_t a[PAIRS] = {0};
                if (k == i || k == j)
                    continue;
                a[pair[i][j]] = 1;
                a[pair[i][k]] = a[pair[j][k]] = -1;
                must(fmb_system_add_int(s, a, FMB_LE, 0));
            }
            most[pair[i][j]] = 1;
            must(fmb_system_add_int(s, most, FMB_LE, 10 + i));
        }
    return s;
}

/* Which rows an elimination drops does not depend on threads either. */
Test(threads, same_elimination)
{
    fmb_system *s = metric_cone();
    char *proof[4];
    for (int k = 0; k < 4; k++) {
        fmb_stop stop;
        fmb_system *p =
            project_by(s, FMB_METHOD_FM, (size_t[]){1, 2, 3, 7}[k], 0, &stop, &proof[k]);
        cr_assert(p && stop == FMB_STOP_DONE && fmb_system_rows(p) > 4);
        cr_expect_str_eq(proof[0], proof[k]);
        fmb_system_free(p);
    }
    for (int k = 0; k < 4; k++)
        free(proof[k]);
    fmb_system_free(s);
}

/* What is known when time is up is proved. */
Test(threads, projection_under_a_limit)
{
    support_rng g = {82};
    fmb_system *s = around_origin(&g, 5);
    static const fmb_method method[] = {FMB_METHOD_HULL, FMB_METHOD_DD, FMB_METHOD_FM};
    for (size_t k = 0; k < 9; k++) {
        char *proof;
        fmb_stop stop;
        fmb_system_free(project_by(s, method[k % 3], 3, 300 * (k / 3 + 1), &stop, &proof));
        cr_expect_eq(stop, FMB_STOP_TIME, "%zu: %s", k, fmb_stop_text(stop));
        free(proof);
    }
    fmb_system_free(s);
}

/* ---- vertices and hulls ---------------------------------------------------------------------- */

static fmb_solver *solver_with_threads(size_t threads)
{
    return must_open((fmb_options){.threads = threads});
}

/* [give] The hull of points, as text. */
static char *hull_by(const fmb_generators *g, size_t threads)
{
    fmb_solver *v = solver_with_threads(threads);
    fmb_system *s = NULL;
    fmb_result r = {.size = sizeof r};
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    must(fmb_hull(v, g, &s, &r));
    cr_assert(s && fmb_system_rows(s) > 300, "%zu rows", s ? fmb_system_rows(s) : 0);
    must(fmb_system_write(s, FMB_FORMAT_INE, f));
    fclose(f);
    fmb_system_free(s);
    fmb_solver_free(v);
    return text;
}

/* [give] Vertices, as text. */
static char *vertices_by(const fmb_system *s, size_t threads)
{
    fmb_solver *v = solver_with_threads(threads);
    fmb_generators *g = NULL;
    fmb_result r = {.size = sizeof r};
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    must(fmb_generate(v, s, &g, &r));
    cr_assert(g && fmb_generators_size(g) > 300, "%zu vertices", g ? fmb_generators_size(g) : 0);
    must(fmb_generators_write(g, f));
    fclose(f);
    fmb_generators_free(g);
    fmb_solver_free(v);
    return text;
}

/* Points about as far from 0 as each other, as vertices and as rows a.x <= |a|. */
static void check_hull_and_vertices(uint64_t seed, int dim, int points)
{
    support_rng g = {seed};
    double x[8];
    int64_t a[8];
    fmb_generators *p = NULL;
    fmb_system *s = rows_none(dim);
    must(fmb_generators_new(dim, NULL, &p));
    for (int i = 0; i < points; i++) {
        double square = 0;
        for (int j = 0; j < dim; j++) {
            x[j] = support_between(&g, -1000, 1000);
            square += x[j] * x[j];
        }
        for (int j = 0; j < dim; j++)
            a[j] = (int64_t)(x[j] = round(10000 * x[j] / sqrt(square)));
        must(fmb_generators_add(p, FMB_VERTEX, x));
        must(fmb_system_add_int(s, a, FMB_LE, 10000));
    }
    char *hull = hull_by(p, 1), *vertices = vertices_by(s, 1);
    static const size_t several[] = {2, 3, 7};
    for (size_t k = 0; k < 3; k++) {
        char *other_hull = hull_by(p, several[k]), *others = vertices_by(s, several[k]);
        cr_expect_str_eq(hull, other_hull);
        cr_expect_str_eq(vertices, others);
        free(others);
        free(other_hull);
    }
    free(vertices);
    free(hull);
    fmb_system_free(s);
    fmb_generators_free(p);
}

Test(threads, same_hull_and_vertices)
{
    check_hull_and_vertices(80, 5, 60);
    check_hull_and_vertices(81, 7, 24);
}
