/* chernikov.c: counts of Chernikov's rule: minimal supports, counted by hand. */
#include <criterion/criterion.h>

#include "bench.h"

/* Follows a permutation of the columns. */
static int choose(void *self, const fmb_view *w, const int *col, size_t n)
{
    (void)w;
    for (const int *p = self;; p++)
        for (size_t i = 0; i < n; i++)
            if (col[i] == *p)
                return col[i];
}

static size_t octahedron_left(const char *rule, int rounds, int *order)
{
    bench b;
    bench_open(&b, 4);
    if (rule)
        bench_use(&b, fmb_rule_find(rule));
    b.how.chooser = (fmb_chooser){choose, order};
    bench_start(&b);
    bench_add_octahedron(&b);
    bench_eliminate(&b, rounds);
    size_t left = b.e.live.size;
    bench_close(&b);
    return left;
}

/* Pairs of opposite signs, and regular tetrahedra. */
Test(chernikov, octahedron)
{
    static int orders[][4] = {{0, 1, 2, 3}, {2, 1, 0, 3}, {1, 2, 0, 3}};
    for (int i = 0; i < 3; i++) {
        cr_expect_eq(octahedron_left("chernikov", 3, orders[i]), 8 + 20);
        cr_expect_eq(octahedron_left("imbert", 3, orders[i]), 8 + 20);
        cr_expect_eq(octahedron_left(NULL, 3, orders[i]), 5870);
    }
}

static void permute(int *p, int from, int n, void (*visit)(int *p, int n))
{
    if (from == n)
        visit(p, n);
    for (int i = from; i < n; i++) {
        int t = p[from];
        p[from] = p[i];
        p[i] = t;
        permute(p, from + 1, n, visit);
        p[i] = p[from];
        p[from] = t;
    }
}

static void eliminate_cube(int *order, int n)
{
    for (int rounds = 1; rounds < n; rounds++) {
        bench b;
        bool drop[BENCH_DIM] = {false};
        bench_open(&b, n);
        bench_use(&b, fmb_rule_find("chernikov"));
        b.how.chooser = (fmb_chooser){choose, order};
        bench_start(&b);
        bench_add_sheared_cube(&b);
        for (int k = 0; k < rounds; k++)
            drop[order[k]] = true;
        cr_assert_eq(fmb_elim_eliminate(&b.e, drop), FMB_OK);
        cr_expect_eq(b.e.live.size, (size_t)(2 * (n - rounds)));
        bench_close(&b);
    }
}

Test(chernikov, sheared_cube_in_any_order)
{
    for (int n = 2; n <= 5; n++) {
        int order[BENCH_DIM] = {0, 1, 2, 3, 4};
        permute(order, 0, n, eliminate_cube);
    }
}

/* x <= 1, -x <= 1, x + y + z <= 1, -x - y - z <= 1, eliminating x and y: crosswise the four make
 * y + z <= 2 and its reverse, and a pair of these would be 0 <= 4. What covers it has said nothing
 * before: 0 <= 2 of the first two rows, and of the last two. An unrelated w raises Kohler's bound,
 * which must not be what drops the pair. */
Test(chernikov, rows_that_said_nothing_cover_others)
{
    static const int64_t row[][5] = {{1, 0, 0, 0, 1},  {-1, 0, 0, 0, 1}, {0, 1, 0, 0, 1},
                                     {0, -1, 0, 0, 1}, {0, 1, 1, 1, 1},  {0, -1, -1, -1, 1}};
    for (int with = 0; with < 2; with++) {
        bench b;
        bench_open(&b, 4);
        bench_use(&b, fmb_rule_find(with ? "chernikov" : "kohler"));
        bench_start(&b);
        for (int i = 0; i < 6; i++)
            bench_add(&b, row[i], FMB_LE);
        bench_eliminate(&b, 3);
        cr_expect_eq(b.e.live.size, 0);
        cr_expect_eq(b.run.stats.rows_made, with ? 1 + 4 : 1 + 4 + 1);
        bench_close(&b);
    }
}
