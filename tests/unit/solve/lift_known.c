/* lift_known.c: images, sums and hulls with known answers, made of lifts and of named variables;
 * and their arguments. */
#include <criterion/criterion.h>

#include <string.h>

#include <fmb/lift.h>

#include "preimages.h"
#include "property/random/agree.h"
#include "support.h"

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

/* ---- names ----------------------------------------------------------------------------------- */

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
