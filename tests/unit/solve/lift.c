/* lift.c: images, sums and hulls of polyhedra: against generators, against the textbook, against
 * known answers; and their arguments. */
#include <criterion/criterion.h>

#include <string.h>

#include <fmb/lift.h>

#include "lifts.h"
#include "property/random/agree.h"
#include "support.h"

/* ---- by generators --------------------------------------------------------------------------- */

/* v + f w as one more generator: each may be NULL. */
static void add_combination(fmb_generators *to, fmb_generator_kind kind, const fmb_generators *v,
                            size_t i, const fmb_generators *w, size_t k)
{
    mpq_t x[8], y;
    mpq_init(y);
    for (int j = 0; j < fmb_generators_dim(to); j++) {
        mpq_init(x[j]);
        fmb_generators_get_q(v, i, j, x[j]);
        if (w)
            fmb_generators_get_q(w, k, j, y);
        mpq_add(x[j], x[j], y);
    }
    must(fmb_generators_add_q(to, kind, x));
    for (int j = 0; j < fmb_generators_dim(to); j++)
        mpq_clear(x[j]);
    mpq_clear(y);
}

/* [give] All sums of vertices, and the directions of both; both are there. */
static fmb_generators *sum_of_generators(const fmb_generators *a, const fmb_generators *b)
{
    fmb_generators *g = NULL;
    must(fmb_generators_new(fmb_generators_dim(a), NULL, &g));
    for (size_t i = 0; i < fmb_generators_size(a); i++) {
        if (fmb_generators_kind(a, i) != FMB_VERTEX)
            add_combination(g, fmb_generators_kind(a, i), a, i, NULL, 0);
        for (size_t k = 0; k < fmb_generators_size(b); k++)
            if (fmb_generators_kind(a, i) == FMB_VERTEX && fmb_generators_kind(b, k) == FMB_VERTEX)
                add_combination(g, FMB_VERTEX, a, i, b, k);
    }
    for (size_t k = 0; k < fmb_generators_size(b); k++)
        if (fmb_generators_kind(b, k) != FMB_VERTEX)
            add_combination(g, fmb_generators_kind(b, k), b, k, NULL, 0);
    return g;
}

/* [give] Those of both, of which one or both may be NULL. */
static fmb_generators *union_of_generators(int dim, const fmb_generators *a,
                                           const fmb_generators *b)
{
    const fmb_generators *of[2] = {a, b};
    fmb_generators *g = NULL;
    must(fmb_generators_new(dim, NULL, &g));
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < fmb_generators_size(of[k]); i++)
            add_combination(g, fmb_generators_kind(of[k], i), of[k], i, NULL, 0);
    return g;
}

/* A graph over n + m variables, whose forms are not written yet. */
static fmb_system *graph_of(int n, int m)
{
    fmb_system *s = rows_none(n + m);
    return s;
}

/* [give] The images of all under y_i = sum_j form[i][j] x_j / 2 + constant[i]; a ray that comes to
 * nothing stays a ray 0, which generates nothing. */
static fmb_generators *image_of_generators(const fmb_generators *a, int m, int form[][4],
                                           const int *constant)
{
    fmb_generators *g = NULL;
    mpq_t y[4], x, t;
    must(fmb_generators_new(m, NULL, &g));
    mpq_inits(x, t, NULL);
    for (int i = 0; i < m; i++)
        mpq_init(y[i]);
    for (size_t k = 0; k < fmb_generators_size(a); k++) {
        fmb_generator_kind kind = fmb_generators_kind(a, k);
        for (int i = 0; i < m; i++) {
            mpq_set_si(y[i], kind == FMB_VERTEX ? constant[i] : 0, 1);
            for (int j = 0; j < fmb_generators_dim(a); j++) {
                fmb_generators_get_q(a, k, j, x);
                mpq_set_si(t, form[i][j], 2);
                mpq_canonicalize(t);
                mpq_mul(t, t, x);
                mpq_add(y[i], y[i], t);
            }
        }
        must(fmb_generators_add_q(g, kind, y));
    }
    for (int i = 0; i < m; i++)
        mpq_clear(y[i]);
    mpq_clears(x, t, NULL);
    return g;
}

/* Their hull has the same points as the closure of answer, and no row of that is too many. */
static void expect_hull_of(fmb_solver *v, fmb_generators *g, const fmb_system *answer,
                           fmb_verdict verdict, uint64_t seed)
{
    agree a = {.max_rows = 20000};
    fmb_system *expected = NULL, *closed = lifts_closure(answer);
    fmb_result r;
    must(fmb_hull(v, g, &expected, &r));
    cr_assert_eq(r.verdict, verdict, "seed %lu", (unsigned long)seed);
    cr_assert(agree_same(&a, closed, expected), "seed %lu: %s", (unsigned long)seed, a.why);
    if (verdict == FMB_FEASIBLE)
        cr_assert(agree_irredundant(&a, answer), "seed %lu: %s", (unsigned long)seed, a.why);
    fmb_system_free(closed);
    fmb_system_free(expected);
    fmb_generators_free(g);
}

/* Two polyhedra with their generators, of any family, small numbers and long ones. */
typedef struct two {
    support_case c[2];
    const fmb_system *s[2];
    fmb_generators *g[2]; /* NULL: empty */
    int dim;
} two;

static two two_at_random(fmb_solver *v, uint64_t seed)
{
    static const int BITS[] = {0, 0, 0, 31, 63};
    support_rng g = {seed};
    fmb_result r;
    two t = {.dim = support_between(&g, 1, 3)};
    for (int k = 0; k < 2; k++) {
        support_shape shape = {t.dim, support_between(&g, 1, 2 * t.dim + 1), BITS[seed % 5]};
        uint64_t family = (seed + (uint64_t)k * (seed / 5)) % SUPPORT_FAMILIES;
        t.c[k] = support_make((support_family)family, 2 * seed + (uint64_t)k, &shape);
        t.s[k] = t.c[k].s;
        must(fmb_generate(v, t.s[k], &t.g[k], &r));
    }
    return t;
}

static void two_clear(two *t)
{
    for (int k = 0; k < 2; k++) {
        support_case_clear(&t->c[k]);
        fmb_generators_free(t->g[k]);
    }
}

Test(lift, sums_are_hulls_of_sums_of_vertices)
{
    int feasible = 0;
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 200; seed++) {
        two t = two_at_random(v, seed);
        bool full = t.g[0] && t.g[1];
        lifts_answer a = lifts_sum(v, t.s, 2);
        cr_assert_eq(a.verdict, full ? FMB_FEASIBLE : FMB_INFEASIBLE, "%lu", (unsigned long)seed);
        if (full)
            expect_hull_of(v, sum_of_generators(t.g[0], t.g[1]), a.out, FMB_FEASIBLE, seed);
        feasible += full;
        lifts_clear(&a);
        two_clear(&t);
    }
    cr_expect(feasible > 60 && feasible < 180, "%d", feasible);
    fmb_solver_free(v);
}

Test(lift, hulls_of_several_are_hulls_of_all_generators)
{
    int mixed = 0;
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 200; seed++) {
        two t = two_at_random(v, seed);
        bool any = t.g[0] || t.g[1];
        lifts_answer a = lifts_hull(v, t.s, 2);
        cr_assert_eq(a.verdict, any ? FMB_FEASIBLE : FMB_INFEASIBLE);
        expect_hull_of(v, union_of_generators(t.dim, t.g[0], t.g[1]), a.out, a.verdict, seed);
        mixed += any && !(t.g[0] && t.g[1]);
        lifts_clear(&a);
        two_clear(&t);
    }
    cr_expect_gt(mixed, 20);
    fmb_solver_free(v);
}

Test(lift, images_are_hulls_of_images_of_generators)
{
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 200; seed++) {
        support_rng rng = {seed};
        two t = two_at_random(v, seed);
        int m = support_between(&rng, 0, 3), form[4][4], constant[4];
        fmb_system *graph = graph_of(t.dim, m);
        for (int i = 0; i < m; i++) {
            int64_t row[8] = {0};
            constant[i] = support_between(&rng, -3, 3);
            for (int j = 0; j < t.dim; j++)
                row[j] = form[i][j] = support_between(&rng, -2, 2);
            row[t.dim + i] = -2;
            must(fmb_system_add_int(graph, row, FMB_EQ, -2 * constant[i]));
        }
        lifts_answer a = lifts_image(v, t.s[0], graph);
        cr_assert_eq(a.verdict, t.g[0] ? FMB_FEASIBLE : FMB_INFEASIBLE);
        cr_assert_eq(fmb_system_dim(a.out), m);
        if (t.g[0])
            expect_hull_of(v, image_of_generators(t.g[0], m, form, constant), a.out, FMB_FEASIBLE,
                           seed);
        lifts_clear(&a);
        fmb_system_free(graph);
        two_clear(&t);
    }
    fmb_solver_free(v);
}

/* The lift of generators is projected on their hull. */
Test(lift, lifts_of_generators_have_their_hulls_as_shadows)
{
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 100; seed++) {
        two t = two_at_random(v, seed);
        fmb_generators *all = union_of_generators(t.dim, t.g[0], t.g[1]);
        fmb_system *s = NULL;
        must(fmb_lift_generators(all, seed % 2 ? t.s[0] : NULL, &s));
        const fmb_system *one[1] = {s};
        lifts_answer a = lifts_sum(v, one, 1);
        expect_hull_of(v, all, a.out, t.g[0] || t.g[1] ? FMB_FEASIBLE : FMB_INFEASIBLE, seed);
        lifts_clear(&a);
        fmb_system_free(s);
        two_clear(&t);
    }
    fmb_solver_free(v);
}

/* ---- strict rows ----------------------------------------------------------------------------- */

/* [give] {(y, a) : a in A, y - a in B} over 2 n variables, written without any lift: the sum is its
 * projection on y. */
static fmb_system *pairs_that_add_up(const fmb_system *a, const fmb_system *b)
{
    int n = fmb_system_dim(a), map[8];
    fmb_system *s = rows_none(2 * n);
    for (int j = 0; j < n; j++)
        map[j] = n + j;
    rows_append_but(s, a, SIZE_MAX, map);
    for (size_t i = 0; i < fmb_system_rows(b); i++) {
        int var[8];
        mpq_t coef[8], right;
        size_t terms = fmb_system_terms(b, i);
        mpq_init(right);
        fmb_system_rhs_q(b, i, right);
        for (size_t k = 0; k < terms; k++) {
            mpq_inits(coef[k], coef[terms + k], NULL);
            var[k] = fmb_system_term_q(b, i, k, coef[k]);
            var[terms + k] = n + var[k];
            mpq_neg(coef[terms + k], coef[k]);
        }
        must(fmb_system_add_q(s, 2 * terms, var, coef, fmb_system_rel(b, i), right));
        for (size_t k = 0; k < 2 * terms; k++)
            mpq_clear(coef[k]);
        mpq_clear(right);
    }
    return s;
}

Test(lift, sums_are_as_strict_as_the_textbook_says)
{
    int strict = 0, keep[2] = {0, 1};
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 300; seed++) {
        support_shape shape = {1 + (int)(seed % 2), 4, 0};
        agree g = {.max_rows = 20000};
        support_case a = support_make(SUPPORT_MIXED, 2 * seed, &shape);
        support_case b = support_make(SUPPORT_PLANTED_POINT, 2 * seed + 1, &shape);
        const fmb_system *both[2] = {a.s, b.s};
        fmb_system *pairs = pairs_that_add_up(a.s, b.s), *textbook = NULL;
        fmb_verdict verdict = FMB_UNKNOWN;
        must(study_textbook_project(pairs, keep, shape.dim, 20000, &textbook, &verdict));
        lifts_answer s = lifts_sum(v, both, 2);
        cr_assert_eq(s.verdict, verdict);
        if (textbook && verdict == FMB_FEASIBLE) {
            cr_assert(agree_same(&g, s.out, textbook), "seed %lu: %s", (unsigned long)seed, g.why);
            for (size_t i = 0; i < fmb_system_rows(s.out); i++)
                strict += fmb_system_rel(s.out, i) == FMB_LT;
        }
        lifts_clear(&s);
        fmb_system_free(textbook);
        fmb_system_free(pairs);
        support_case_clear(&a);
        support_case_clear(&b);
    }
    cr_expect_gt(strict, 50, "%d", strict);
    fmb_solver_free(v);
}

/* ---- known answers --------------------------------------------------------------------------- */

/* The segment from 0 to x. */
static fmb_system *segment_to(int n, const double *x)
{
    fmb_generators *g = NULL;
    fmb_system *s = NULL;
    double zero[8] = {0};
    must(fmb_generators_new(n, NULL, &g));
    must(fmb_generators_add(g, FMB_VERTEX, zero));
    must(fmb_generators_add(g, FMB_VERTEX, x));
    must(fmb_lift_generators(g, NULL, &s));
    fmb_generators_free(g);
    return s;
}

static size_t rows_of_sum(fmb_solver *v, fmb_system **s, size_t n)
{
    lifts_answer a = lifts_sum(v, (const fmb_system *const *)s, n);
    size_t rows = fmb_system_rows(a.out);
    lifts_clear(&a);
    for (size_t k = 0; k < n; k++)
        fmb_system_free(s[k]);
    return rows;
}

/* Facets and one equality: Ziegler 1995, example 0.10: 2^n - 2 facets. */
Test(lift, a_permutahedron_is_the_sum_of_its_edges)
{
    fmb_solver *v = lifts_solver();
    for (int n = 2; n <= 5; n++) {
        fmb_system *edge[10];
        size_t edges = 0;
        for (int i = 0; i < n; i++)
            for (int j = i + 1; j < n; j++) {
                double x[8] = {0};
                x[i] = 1;
                x[j] = -1;
                edge[edges++] = segment_to(n, x);
            }
        cr_expect_eq(rows_of_sum(v, edge, edges), ((size_t)1 << n) - 2 + 1, "%d", n);
    }
    fmb_solver_free(v);
}

/* k segments of the plane, no two of them parallel: a polygon of 2 k edges. */
Test(lift, a_zonogon_has_two_edges_for_each_segment)
{
    fmb_solver *v = lifts_solver();
    for (size_t k = 2; k <= 7; k++) {
        fmb_system *s[8];
        for (size_t i = 0; i < k; i++)
            s[i] = segment_to(2, (double[]){1, (double)(i * i)});
        cr_expect_eq(rows_of_sum(v, s, k), 2 * k);
    }
    fmb_solver_free(v);
}

/* The cube [-1, 1]^n. */
static fmb_system *cube(int n)
{
    fmb_system *s = rows_none(n);
    for (int j = 0; j < 2 * n; j++) {
        int64_t a[8] = {0};
        a[j / 2] = j % 2 ? 1 : -1;
        must(fmb_system_add_int(s, a, FMB_LE, 1));
    }
    return s;
}

/* The cross-polytope of that radius. */
static fmb_system *cross(int n, double radius)
{
    fmb_generators *g = NULL;
    fmb_system *s = NULL;
    must(fmb_generators_new(n, NULL, &g));
    for (int j = 0; j < 2 * n; j++) {
        double x[8] = {0};
        x[j / 2] = j % 2 ? radius : -radius;
        must(fmb_generators_add(g, FMB_VERTEX, x));
    }
    must(fmb_lift_generators(g, NULL, &s));
    fmb_generators_free(g);
    return s;
}

/* Each face of the cube goes out along its normal: sum_(j in J) s_j x_j <= |J| + 1 for every
 * nonempty J and signs s, 3^n - 1 facets. */
Test(lift, cube_plus_cross_polytope)
{
    fmb_solver *v = lifts_solver();
    size_t facets = 1;
    for (int n = 1; n <= 4; n++) {
        fmb_system *s[2] = {cube(n), cross(n, 1)};
        facets *= 3;
        cr_expect_eq(rows_of_sum(v, s, 2), facets - 1);
    }
    fmb_solver_free(v);
}

/* A cube and a cross-polytope just as high as its faces (nothing new), and one twice as far: a
 * pyramid on each face, of which each side is a facet, 2 n 2 (n - 1) in all; in two dimensions the
 * sides of two of them lie in one line. */
Test(lift, cube_and_cross_polytope)
{
    fmb_solver *v = lifts_solver();
    for (int n = 3; n <= 4; n++)
        for (int far = 1; far <= 2; far++) {
            fmb_system *s[2] = {cube(n), cross(n, far)};
            lifts_answer a = lifts_hull(v, (const fmb_system *const *)s, 2);
            size_t sides = (size_t)(2 * n) * (size_t)(n - 1); /* each is that of two pyramids */
            cr_expect_eq(fmb_system_rows(a.out), far == 1 ? (size_t)(2 * n) : sides, "%d %d", n,
                         far);
            lifts_clear(&a);
            fmb_system_free(s[0]);
            fmb_system_free(s[1]);
        }
    fmb_solver_free(v);
}

/* The hull of a line and a point beside it is not closed; its closure is the strip. */
Test(lift, the_hull_is_closed)
{
    fmb_solver *v = lifts_solver();
    fmb_system *line = rows_none(2), *point = rows_none(2), *empty = rows_none(2);
    must(fmb_system_add_int(line, (int64_t[]){0, 1}, FMB_EQ, 0));
    must(fmb_system_add_int(point, (int64_t[]){1, 0}, FMB_EQ, 5));
    must(fmb_system_add_int(point, (int64_t[]){0, 1}, FMB_EQ, 1));
    must(fmb_system_add_int(empty, (int64_t[]){1, 0}, FMB_LT, 0));
    must(fmb_system_add_int(empty, (int64_t[]){1, 0}, FMB_GT, 0));
    lifts_answer a = lifts_hull(v, (const fmb_system *[]){line, empty, point}, 3);
    cr_assert_eq(fmb_system_rows(a.out), 2);
    for (size_t i = 0; i < 2; i++)
        cr_expect(fmb_system_terms(a.out, i) == 1 && fmb_system_rel(a.out, i) == FMB_LE);
    lifts_clear(&a);
    a = lifts_hull(v, (const fmb_system *[]){empty, empty}, 2);
    cr_expect(a.verdict == FMB_INFEASIBLE && fmb_system_rows(a.out) == 1);
    lifts_clear(&a);
    fmb_system_free(line);
    fmb_system_free(point);
    fmb_system_free(empty);
    fmb_solver_free(v);
}

/* ---- lifts as parts of lifts, names ---------------------------------------------------------- */

Test(lift, lifts_are_polyhedra_too)
{
    agree g = {.max_rows = 20000};
    fmb_solver *v = lifts_solver();
    for (uint64_t seed = 0; seed < 60; seed++) {
        two t = two_at_random(v, seed);
        lifts_answer h = lifts_hull(v, t.s, 2);
        lifts_answer a = lifts_sum(v, (const fmb_system *[]){h.lift, t.s[1]}, 2);
        lifts_answer b = lifts_sum(v, (const fmb_system *[]){h.out, t.s[1]}, 2);
        cr_assert_eq(a.verdict, b.verdict);
        cr_assert(agree_same(&g, a.out, b.out), "seed %lu: %s", (unsigned long)seed, g.why);
        lifts_clear(&a);
        lifts_clear(&b);
        lifts_clear(&h);
        two_clear(&t);
    }
    fmb_solver_free(v);
}

static fmb_system *parse(const char *text)
{
    fmb_system *s = NULL;
    fmb_where where;
    cr_assert_eq(fmb_system_parse(text, strlen(text), NULL, &s, &where), FMB_OK, "%s", where.text);
    return s;
}

/* Variables by their names, in the order of the first; names of copies give way. */
Test(lift, variables_are_matched_by_name)
{
    agree g = {.max_rows = 1000};
    fmb_solver *v = lifts_solver();
    fmb_system *a = parse("vars: x x_1 y\nproject: y x\nx = x_1\nx_1 = 2\ny = 3\n");
    fmb_system *b = parse("vars: y x\ny = 20\nx = 10\n");
    fmb_system *sum = parse("vars: x y\nx = 12\ny = 23\n");
    lifts_answer s = lifts_sum(v, (const fmb_system *[]){a, b}, 2);
    cr_expect_str_eq(fmb_system_name(s.out, 0), "x");
    cr_expect_str_eq(fmb_system_name(s.out, 1), "y");
    cr_expect(agree_same(&g, s.out, sum), "%s", g.why);
    cr_expect_eq(fmb_system_dim(s.lift), 7);
    lifts_clear(&s);
    fmb_system_free(a);
    fmb_system_free(b);
    fmb_system_free(sum);
    fmb_solver_free(v);
}

Test(lift, what_does_not_fit_is_told)
{
    fmb_solver *v = lifts_solver();
    fmb_system *a = parse("vars: x y\nx = y\n"), *b = parse("vars: x z\nx = z\n");
    fmb_system *c = parse("vars: x\nx = 1\n"), *out = a, *lift = b;
    cr_expect_eq(fmb_sum(v, (const fmb_system *[]){a, b}, 2, &lift, &out, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "variable 'z' of number 2 is not one of number 1");
    cr_expect_eq(fmb_hull_union(v, (const fmb_system *[]){a, c}, 2, &lift, &out, NULL),
                 FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "number 2 has 1 variables, but number 1 has 2");
    cr_expect_eq(fmb_sum(v, (const fmb_system *[]){a, NULL}, 2, &lift, &out, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "s[1] is NULL");
    cr_expect_eq(fmb_sum(v, (const fmb_system *[]){a}, 0, &lift, &out, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_hull_union(v, NULL, 1, &lift, &out, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_image(v, a, c, &lift, &out, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "the graph has 1 variables, but the system keeps 2");
    cr_expect_eq(fmb_image(v, NULL, c, &lift, &out, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(v), "s is NULL");
    cr_expect_eq(fmb_image(v, a, a, &lift, NULL, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_image(NULL, a, a, &lift, &out, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_lift_generators(NULL, NULL, &out), FMB_ERR_ARG);
    cr_expect(out == a && lift == b);
    fmb_system_free(a);
    fmb_system_free(b);
    fmb_system_free(c);
    fmb_solver_free(v);
}
