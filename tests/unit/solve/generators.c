/* generators.c: vertices, rays and lines of systems, and their hulls: round trips. */
#include <criterion/criterion.h>

#include <math.h>
#include <string.h>

#include <fmb/generators.h>

#include "counted_clock.h"
#include "fault/hook.h"
#include "property/random/agree.h"
#include "support.h"
#include "system/system_private.h"

static fmb_solver *plain_solver(void)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

static size_t count_kind(const fmb_generators *g, fmb_generator_kind kind)
{
    size_t n = 0;
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        n += fmb_generators_kind(g, i) == kind;
    return n;
}

Test(generators, a_cube_has_its_corners)
{
    fmb_solver *v = plain_solver();
    fmb_system *s = rows_none(3);
    fmb_generators *g = NULL;
    fmb_result r = {.size = sizeof r};
    for (int j = 0; j < 6; j++) {
        int64_t a[3] = {0};
        a[j / 2] = j % 2 ? 2 : -2;
        must(fmb_system_add_int(s, a, FMB_LE, j % 2));
    }
    must(fmb_generate(v, s, &g, &r));
    cr_assert(g && r.verdict == FMB_FEASIBLE);
    cr_expect(fmb_generators_dim(g) == 3 && fmb_generators_size(g) == 8);
    cr_expect_eq(count_kind(g, FMB_VERTEX), 8);
    cr_expect_eq(fmb_generators_coordinate(g, 7, 2), 0.5);
    cr_expect_eq(fmb_generators_coordinate(g, 8, 2), 0);
    fmb_generators_free(g);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* The closure of s, as generators say it; NULL if it is empty. */
static fmb_system *there_and_back(fmb_solver *v, const fmb_system *s, fmb_verdict *verdict)
{
    fmb_generators *g = NULL;
    fmb_system *t = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    must(fmb_generate(v, s, &g, &r));
    *verdict = r.verdict;
    cr_assert_eq(g != NULL, r.verdict == FMB_FEASIBLE);
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted, "%s", j.reason);
    fmb_evidence_free(e);
    if (!g)
        return NULL;
    must(fmb_hull(v, g, &t, &r));
    cr_assert(t && r.verdict == FMB_FEASIBLE);
    cr_assert_eq(fmb_solver_evidence(v, &e), FMB_ERR_STATE);
    fmb_generators_free(g);
    return t;
}

/* Every sixth has more rows than its dimension would let one expect: another way leads there. */
Test(generators, there_and_back_again)
{
    static const int BITS[] = {0, 0, 31, 63, 200};
    int feasible = 0;
    agree a = {.max_rows = 5000};
    fmb_solver *v = plain_solver();
    for (uint64_t seed = 0; seed < 400; seed++) {
        support_rng g = {seed};
        int n = support_between(&g, 1, 4), many = seed % 6 == 0 ? 4 * n + 16 : 8;
        support_shape shape = {n, support_between(&g, many / 8, many), BITS[seed % 5]};
        support_case c = support_make((support_family)(seed % SUPPORT_FAMILIES), seed, &shape);
        fmb_verdict verdict;
        fmb_system *t = there_and_back(v, c.s, &verdict);
        cr_assert(c.verdict == FMB_UNKNOWN || c.verdict == verdict, "seed %lu",
                  (unsigned long)seed);
        if (t) {
            fmb_system *closed = support_closure(c.s);
            cr_assert(agree_same(&a, closed, t), "seed %lu: %s", (unsigned long)seed, a.why);
            cr_assert(agree_irredundant(&a, t), "seed %lu: %s", (unsigned long)seed, a.why);
            fmb_system_free(closed);
            feasible++;
        }
        fmb_system_free(t);
        support_case_clear(&c);
    }
    cr_expect_gt(feasible, 150);
    fmb_solver_free(v);
}

/* Signs in 2^n rows: between its rows in the wrong order there are very many rays. */
static fmb_system *cross_polytope(int n)
{
    fmb_system *s = rows_none(n);
    for (unsigned signs = 0; signs < 1u << n; signs++) {
        int64_t a[16];
        for (int j = 0; j < n; j++)
            a[j] = signs >> j & 1 ? 1 : -1;
        must(fmb_system_add_int(s, a, FMB_LE, 1));
    }
    return s;
}

Test(generators, a_cross_polytope_has_two_vertices_for_each_coordinate)
{
    fmb_solver *v = plain_solver();
    for (int n = 2; n <= 9; n++) {
        fmb_system *s = cross_polytope(n), *t = NULL;
        fmb_generators *g = NULL;
        fmb_result r = {.size = sizeof r};
        must(fmb_generate(v, s, &g, &r));
        cr_assert(g && fmb_generators_size(g) == 2 * (size_t)n);
        for (size_t i = 0; i < fmb_generators_size(g); i++) {
            double sum = 0;
            for (int j = 0; j < n; j++)
                sum += fabs(fmb_generators_coordinate(g, i, j));
            cr_expect_eq(sum, 1);
        }
        must(fmb_hull(v, g, &t, &r));
        cr_expect_eq(fmb_system_rows(t), (size_t)1 << n);
        fmb_system_free(t);
        fmb_generators_free(g);
        fmb_system_free(s);
    }
    fmb_solver_free(v);
}

/* Rows that touch a ball, nearly, with numbers of so many bits; or a prism over that. */
static fmb_system *rows_around_ball(const int size[3], bool prism, uint64_t seed)
{
    int n = size[0], most = 1 << size[2];
    fmb_system *s = rows_none(n + prism);
    support_rng g = {seed};
    int64_t a[16] = {0};
    for (int i = 0; i < size[1]; i++) {
        double square = 0;
        for (int j = 0; j < n; j++) {
            a[j] = support_between(&g, -most, most);
            square += (double)a[j] * (double)a[j];
        }
        must(fmb_system_add_int(s, a, FMB_LE, (int64_t)sqrt(square) + 1));
    }
    memset(a, 0, sizeof a);
    for (int side = 0; prism && side < 2; side++) {
        a[n] = side ? 1 : -1;
        must(fmb_system_add_int(s, a, FMB_LE, side));
    }
    return s;
}

/* Do the first n coordinates of point i of g, rounded, stand among those of h? */
static bool is_point_among(const fmb_generators *g, size_t i, const fmb_generators *h, int n)
{
    for (size_t k = 0; k < fmb_generators_size(h); k++) {
        int same = 0;
        while (same < n &&
               fmb_generators_coordinate(g, i, same) == fmb_generators_coordinate(h, k, same))
            same++;
        if (same == n)
            return true;
    }
    return false;
}

/* Many rows, and rays of more bits than int64 has, go another way with one coordinate more. */
Test(generators, a_prism_has_its_base_twice)
{
    static const int SIZES[][3] = {{6, 28, 11}, {6, 28, 5}, {5, 24, 20}};
    fmb_solver *v = plain_solver();
    for (uint64_t seed = 0; seed < (2 + WATCHED) / WATCHED; seed++) {
        fmb_system *s = rows_around_ball(SIZES[seed], false, seed);
        fmb_system *t = rows_around_ball(SIZES[seed], true, seed);
        fmb_generators *base = NULL, *prism = NULL;
        fmb_result r = {.size = sizeof r};
        must(fmb_generate(v, s, &base, &r));
        must(fmb_generate(v, t, &prism, &r));
        cr_assert_eq(fmb_generators_size(prism), 2 * fmb_generators_size(base));
        for (size_t i = 0; i < fmb_generators_size(base); i++)
            cr_assert(is_point_among(base, i, prism, SIZES[seed][0]), "seed %d, %zu", (int)seed, i);
        fmb_system_free(t);
        fmb_system_free(s);
        fmb_generators_free(base);
        fmb_generators_free(prism);
    }
    fmb_solver_free(v);
}

/* Very many rows: of those that touch a cube in a corner, or along a face, none cuts one off. */
Test(generators, a_cube_among_rows_that_touch_it)
{
    enum { N = 6, ROWS = 240 };
    fmb_solver *v = plain_solver();
    fmb_system *s = rows_none(N);
    fmb_generators *g = NULL;
    fmb_result r = {.size = sizeof r};
    support_rng random = {7};
    for (int i = 0; i < ROWS; i++) {
        int64_t a[N] = {0}, sum = 0;
        for (int j = 0; j < N; j++) {
            a[j] = i < 2 * N ? (j == i / 2) * (i % 2 ? 1 : -1) : support_between(&random, -9, 9);
            sum += a[j] < 0 ? -a[j] : a[j];
        }
        must(fmb_system_add_int(s, a, FMB_LE, sum));
    }
    must(fmb_generate(v, s, &g, &r));
    cr_assert_eq(fmb_generators_size(g), 1 << N);
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        for (int j = 0; j < N; j++)
            cr_expect_eq(fabs(fmb_generators_coordinate(g, i, j)), 1);
    fmb_generators_free(g);
    fmb_system_free(s);
    fmb_solver_free(v);
}

Test(generators, by_hand)
{
    fmb_solver *v = plain_solver();
    fmb_generators *g = NULL;
    fmb_system *t = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_generators_new(2, NULL, &g));
    must(fmb_hull(v, g, &t, &r));
    cr_assert(r.verdict == FMB_INFEASIBLE && fmb_system_rows(t) == 1);
    fmb_system_free(t);
    must(fmb_generators_add(g, FMB_VERTEX, (double[]){0.5, 0}));
    must(fmb_generators_add(g, FMB_RAY, (double[]){1, 0}));
    must(fmb_generators_add(g, FMB_LINE, (double[]){0, 1}));
    must(fmb_hull(v, g, &t, &r));
    cr_assert(r.verdict == FMB_FEASIBLE && fmb_system_rows(t) == 1);
    fmb_system_free(t);
    mpq_t x[2], q;
    mpq_inits(x[0], x[1], q, NULL);
    mpq_set_si(x[0], -1, 3);
    must(fmb_generators_add_q(g, FMB_VERTEX, x));
    fmb_generators_coordinate_q(g, 3, 0, q);
    cr_expect(mpq_equal(q, x[0]));
    mpq_clears(x[0], x[1], q, NULL);
    cr_expect_eq(fmb_generators_kind(g, 2), FMB_LINE);
    cr_expect_eq(fmb_generators_add(g, FMB_VERTEX, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_add(g, (fmb_generator_kind)7, (double[]){0, 0}), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_new(-1, NULL, &g), FMB_ERR_ARG);
    cr_expect_eq(fmb_hull(v, NULL, &t, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_generate(v, NULL, &g, &r), FMB_ERR_ARG);
    fmb_generators_free(g);
    fmb_solver_free(v);
}

/* Facets of simplices all, whose polar has very many vertices for so few rows: as a hull of these
 * it is found by a section. */
static fmb_system *polar_of_moment_curve(int n, int points)
{
    fmb_system *s = rows_none(n);
    for (int t = 0; t < points; t++) {
        int64_t a[16], power = 1, at = 2 * t - points + 1;
        for (int j = 0; j < n; j++)
            a[j] = power *= at;
        must(fmb_system_add_int(s, a, FMB_LE, 1));
    }
    return s;
}

Test(generators, very_many_points_of_few_facets)
{
    agree a = {.max_rows = 5000};
    fmb_solver *v = plain_solver();
    fmb_system *s = polar_of_moment_curve(7, 16), *t = NULL;
    fmb_generators *g = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_generate(v, s, &g, &r));
    cr_assert_geq(fmb_generators_size(g), 300);
    must(fmb_hull(v, g, &t, &r));
    cr_expect_eq(fmb_system_rows(t), fmb_system_rows(s));
    cr_expect(agree_same(&a, s, t), "%s", a.why);
    fmb_system_free(t);
    fmb_generators_free(g);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* NULL, or some vertices of the cube [-1, 1]^n. */
static void check_some_corners(const fmb_generators *g, const fmb_result *r, int n)
{
    cr_assert(!g || r->verdict == FMB_FEASIBLE);
    for (size_t i = 0; g && i < fmb_generators_size(g); i++) {
        cr_assert_eq(fmb_generators_kind(g, i), FMB_VERTEX);
        for (int j = 0; j < n; j++)
            cr_assert_eq(fabs(fmb_generators_coordinate(g, i, j)), 1);
    }
}

Test(generators, at_a_limit)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_system *s = rows_none(18);
    fmb_generators *g = NULL;
    fmb_result r = {.size = sizeof r};
    o.max_bytes = 1 << 20;
    must(fmb_solver_new(&o, NULL, &v));
    for (int j = 0; j < 36; j++) {
        int64_t a[18] = {0};
        a[j / 2] = j % 2 ? 1 : -1;
        must(fmb_system_add_int(s, a, FMB_LE, 1));
    }
    must(fmb_generate(v, s, &g, &r));
    cr_expect(r.stop == FMB_STOP_BYTES);
    check_some_corners(g, &r, 18);
    fmb_generators_free(g);
    g = NULL;
    o.max_bytes = 0;
    o.max_rows = 5000; /* a cube of 18 dimensions has more corners */
    fmb_solver_free(v);
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_generate(v, s, &g, &r));
    cr_assert(g && r.stop == FMB_STOP_ROWS);
    cr_expect(fmb_generators_size(g) > 1 && fmb_generators_size(g) < 5000);
    check_some_corners(g, &r, 18);
    fmb_generators_free(g);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* No generator violates row i: integers all. */
static void check_row_holds(const fmb_system *s, size_t i, const fmb_generators *g)
{
    const fmb_sysrow *row = fmb_system_row(s, i);
    mpz_t sum, t;
    mpz_inits(sum, t, NULL);
    for (size_t k = 0; k < fmb_generators_size(g); k++) {
        fmb_generator_kind kind = fmb_generators_kind(g, k);
        mpz_set_ui(sum, 0);
        if (kind == FMB_VERTEX)
            fmb_vec_get(&row->val, row->nnz, sum);
        for (size_t j = 0; j < row->nnz; j++) {
            fmb_vec_get(&row->val, j, t);
            mpz_mul_si(t, t, (long)fmb_generators_coordinate(g, k, row->var[j]));
            mpz_sub(sum, sum, t);
        }
        cr_assert(kind == FMB_LINE ? mpz_sgn(sum) == 0 : mpz_sgn(sum) >= 0);
    }
    mpz_clears(sum, t, NULL);
}

/* Of the hull of a cloud, and of one that a ray and a line go through. */
Test(generators, some_rows_at_a_limit)
{
    enum { N = 9, POINTS = 200 };
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.max_seconds = 200;
    must(fmb_solver_new(&o, NULL, &v));
    for (int flat = 0; flat < 2; flat++) {
        support_rng random = {5};
        fmb_generators *g = NULL;
        fmb_system *s = NULL;
        fmb_result r = {.size = sizeof r};
        double x[N];
        must(fmb_generators_new(N, NULL, &g));
        for (int i = 0; i < POINTS; i++) {
            for (int j = 0; j < N; j++)
                x[j] = support_between(&random, -1000, 1000);
            fmb_generator_kind kind =
                flat && i < 2 ? (fmb_generator_kind)(FMB_RAY + i) : FMB_VERTEX;
            must(fmb_generators_add(g, kind, x));
        }
        counted_clock_start(0, NULL, NULL);
        must(fmb_hull(v, g, &s, &r));
        counted_clock_stop();
        cr_assert(r.stop == FMB_STOP_TIME && (!s || r.verdict == FMB_FEASIBLE));
        for (size_t i = 0; s && i < fmb_system_rows(s); i++)
            check_row_holds(s, i, g);
        fmb_system_free(s);
        fmb_generators_free(g);
    }
    fmb_solver_free(v);
}

/* ---- memory that runs out -------------------------------------------------------------------- */

static fmb_status ask_there_and_back(fmb_solver *v, const fmb_system *s)
{
    fmb_generators *g = NULL;
    fmb_system *t = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_status st = fmb_generate(v, s, &g, &r);
    if (st == FMB_OK && g)
        st = fmb_hull(v, g, &t, &r);
    fmb_system_free(t);
    fmb_generators_free(g);
    return st;
}

/* Of many requests some. */
static void let_requests_fail(const fmb_system *s, size_t every)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st == FMB_ERR_MEMORY; k += 1 + k / every) {
        must(fmb_solver_new(&o, &mem, &v));
        hook_arm(&h, k, k % 2 == 0);
        st = ask_there_and_back(v, s);
        hook_calm(&h);
        fmb_solver_free(v);
        cr_assert_eq(h.live, 0, "request %zu: %zu bytes leak", k, h.live);
        cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY);
    }
}

Test(generators, every_request_may_fail)
{
    support_shape few = {3, 7, 63}, many = {2, 30, 63};
    support_case c = support_make(SUPPORT_PLANTED_POINT, 3, &few);
    let_requests_fail(c.s, SIZE_MAX);
    support_case_clear(&c);
    c = support_make(SUPPORT_PLANTED_POINT, 3, &many);
    let_requests_fail(c.s, SIZE_MAX);
    support_case_clear(&c);
    fmb_system *cross = cross_polytope(8);
    let_requests_fail(cross, 8);
    fmb_system_free(cross);
}

/* ---- V-representations ----------------------------------------------------------------------- */

static const char EXT[] = "V-representation\nlinearity 1 3\nbegin\n3 3 rational\n"
                          "1 1/2 -5\n0 1 1\n0 0 1\nend\n";

Test(generators, are_written_and_read)
{
    fmb_generators *g = NULL, *h = NULL;
    fmb_where where;
    char text[256] = "";
    FILE *file = tmpfile();
    must(fmb_generators_parse(EXT, sizeof EXT - 1, NULL, &g, &where));
    cr_assert_eq(fmb_generators_size(g), 3);
    cr_expect(fmb_generators_kind(g, 0) == FMB_VERTEX && fmb_generators_kind(g, 1) == FMB_RAY);
    cr_expect_eq(fmb_generators_kind(g, 2), FMB_LINE);
    cr_expect(fmb_generators_coordinate(g, 0, 0) == 0.5 &&
              fmb_generators_coordinate(g, 0, 1) == -5);
    must(fmb_generators_write(g, file));
    rewind(file);
    cr_assert_eq(fread(text, 1, sizeof text - 1, file), sizeof EXT - 1);
    cr_expect_str_eq(text, EXT);
    rewind(file);
    must(fmb_generators_read(file, NULL, &h, &where));
    cr_expect_eq(fmb_generators_size(h), 3);
    fclose(file);
    fmb_generators_free(g);
    fmb_generators_free(h);
}

Test(generators, bad_texts_are_told)
{
    static const struct {
        const char *text;
        long line;
    } bad[] = {{"", 0},
               {"H-representation\nbegin\n1 2 integer\n1 0\nend\n", 1},
               {"V-representation\nbegin\n1 2 integer\n1 x\nend\n", 4},
               {"V-representation\nbegin\n1 2 integer\n-1 1\nend\n", 4},
               {"V-representation\nbegin\n2 2 integer\n1 1\n 2 1\nend\n", 5},
               {"V-representation\nlinearity 1 1\nbegin\n1 2 integer\n1 1\nend\n", 2}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        fmb_generators *g = NULL;
        fmb_where where = {0};
        cr_expect_eq(fmb_generators_parse(bad[i].text, strlen(bad[i].text), NULL, &g, &where),
                     FMB_ERR_PARSE);
        cr_expect(!g && (bad[i].line == 0 || where.line == bad[i].line), "%zu: line %ld", i,
                  (long)where.line);
    }
    fmb_generators *g = NULL;
    cr_expect_eq(fmb_generators_parse(NULL, 1, NULL, &g, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_read(NULL, NULL, &g, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_write(NULL, stdout), FMB_ERR_ARG);
}
