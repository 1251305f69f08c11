/* cycling.c: programs on which the rule of the largest coefficient would cycle, were it not for
 * Bland's rule, which takes over after some fifty degenerate pivots in a row.
 *
 * Sources: Beale 1955, Cycling in the dual simplex algorithm; Kuhn's example in Balinski and Tucker
 * 1969, Duality theory of linear programs: a constructive approach with applications.
 */
#include <criterion/criterion.h>
#include <string.h>

#include "bareiss.h"
#include "lp/oracle/pivot_walk.h"
#include "vertex_bench.h"

enum { MOST = 12, STALL = 50 };

/* Maximise the last variable. A rule of largest coefficients depends on the size of slacks, and a
 * row is divided by its common factor; so where fractions stand in a row, its slack is a variable
 * of ours that has a sign row. Of rows that stop a step at once, the first one counts. */
typedef struct program {
    const char *name;
    int n;
    size_t rows, inequalities; /* the latter come first */
    int64_t row[MOST][MOST];
    size_t corner[MOST]; /* rows that are tight where the walk begins */
    long best, over;     /* the optimum, as a fraction */
} program;

static const program PROGRAMS[] = {
    {"Beale",
     8,
     11,
     7,
     {{-1},
      {0, -1},
      {0, 0, -1},
      {0, 0, 0, -1},
      {0, 0, 0, 0, -1},
      {0, 0, 0, 0, 0, -1},
      {0, 0, 0, 0, 0, 0, -1},
      {25, -6000, -4, 900, 100, 0, 0, 0, 0},
      {50, -9000, -2, 300, 0, 100, 0, 0, 0},
      {0, 0, 1, 0, 0, 0, 1, 0, 1},
      {75, -15000, 2, -600, 0, 0, 0, -100, 0}},
     {0, 1, 2, 3, 7, 8, 9, 10},
     1,
     20},
    {"Kuhn",
     6,
     9,
     7,
     {{-2, -9, 1, 9},
      {2, 3, -1, -12, 0, 0, 2},
      {-1},
      {0, -1},
      {0, 0, -1},
      {0, 0, 0, -1},
      {0, 0, 0, 0, -1},
      {1, 3, -1, -6, 3, 0, 0},
      {2, 3, -1, -12, 0, -1, 0}},
     {2, 3, 4, 5, 7, 8},
     2,
     1},
};

static void solve_program(const program *p)
{
    vertex_bench b;
    fmb_pivot_walk w;
    fmb_pivot_walk_end end;
    mpz_t *cost = bareiss_numbers((size_t)p->n), value;
    vertex_bench_open(&b);
    fmb_program_init(&b.p, &b.mem, p->n);
    for (size_t i = 0; i < p->rows; i++) {
        int64_t words[MOST];
        fmb_vec v = {.s = words};
        memcpy(words, p->row[i], sizeof words);
        fmb_vec_measure(&v, (size_t)p->n + 1);
        cr_assert_eq(fmb_program_add_dense(&b.p, &v, i < p->inequalities ? FMB_LE : FMB_EQ),
                     FMB_OK);
    }
    vertex_bench_stand(&b);
    cr_assert_eq(fmb_pivot_walk_init(&w, &b.v), FMB_OK);
    cr_assert_eq(fmb_vertex_set(&b.v, p->corner), FMB_OK);
    mpz_set_ui(cost[p->n - 1], 1);
    uint64_t before = b.run.stats.pivots;
    cr_assert_eq(fmb_pivot_walk_to_optimum(&w, 0, cost, &end), FMB_OK);
    cr_expect_eq(end, FMB_PIVOT_WALK_REACHED, "%s", p->name);
    cr_expect_gt(b.run.stats.pivots - before, STALL, "%s takes %lu pivots: does it stall?", p->name,
                 (unsigned long)(b.run.stats.pivots - before));
    mpz_init(value);
    mpz_mul_si(value, b.v.x.z[p->n - 1], p->over);
    mpz_submul_ui(value, b.v.den, (unsigned long)p->best);
    cr_expect_eq(mpz_sgn(value), 0, "%s", p->name);
    mpz_clear(value);
    bareiss_free(cost, (size_t)p->n);
    fmb_pivot_walk_clear(&w);
    vertex_bench_close(&b);
}

Test(cycling, ends_by_blands_rule, .timeout = 30)
{
    for (size_t i = 0; i < sizeof PROGRAMS / sizeof *PROGRAMS; i++)
        solve_program(&PROGRAMS[i]);
}
