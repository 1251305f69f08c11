/* cycling.c: programs on which the rule of the largest coefficient goes round for ever, were it not
 * for Bland's rule, which takes over when 16 pivots in a row have moved nothing.
 *
 * Sources: Beale 1955, Cycling in the dual simplex algorithm; Kuhn's example in Balinski and Tucker
 * 1969, Duality theory of linear programs: a constructive approach with applications.
 */
#include <criterion/criterion.h>
#include <string.h>

#include "lp/dictionary/dictionary_read.h"
#include "lp/dictionary/exact_simplex.h"

enum { MOST = 12, STALL = 16 };

/* Maximise the last variable. A rule of largest coefficients depends on the size of slacks, and a
 * row is divided by its common factor; so where fractions stand in a row, its slack is a variable
 * of ours that has a sign row. Of rows that stop a step at once, the first one counts. */
typedef struct program {
    const char *name;
    int n;
    size_t rows, inequalities; /* the latter come first */
    int64_t row[MOST][MOST];
    long best, over; /* the optimum, as a fraction */
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
     2,
     1},
};

static void solve_program(const program *p, bool wide)
{
    fmb_options o = {.size = sizeof o};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_lp lp;
    fmb_vec v[MOST] = {{0}};
    fmb_lp_row row[MOST];
    int64_t words[MOST][MOST];
    bool feasible;
    int step;
    fmb_lp_end end;
    mpq_t value, best;
    mpq_inits(value, best, NULL);
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (size_t i = 0; i < p->rows; i++) {
        memcpy(words[i], p->row[i], sizeof words[i]);
        v[i].s = words[i];
        fmb_vec_measure(&v[i], (size_t)p->n + 1);
        row[i] = (fmb_lp_row){&v[i], i < p->inequalities ? FMB_LE : FMB_EQ};
    }
    cr_assert_eq(fmb_lp_init(&lp, &run, p->n, p->rows, row, wide), FMB_OK);
    cr_assert_eq(fmb_lp_feasible(&lp, &feasible), FMB_OK);
    cr_assert(feasible);
    uint64_t before = run.stats.pivots;
    cr_assert_eq(fmb_lp_extreme(&lp, p->n - 1, 1, &end), FMB_OK);
    cr_expect_eq(end, FMB_LP_OPTIMUM, "%s", p->name);
    cr_expect_gt(run.stats.pivots - before, STALL, "%s takes %lu pivots: does it stall?", p->name,
                 (unsigned long)(run.stats.pivots - before));
    fmb_lp_value(&lp, value, &step);
    mpq_set_si(best, p->best, (unsigned long)p->over);
    cr_expect(mpq_equal(value, best), "%s", p->name);
    fmb_lp_clear(&lp);
    cr_expect_eq(mem.used, 0);
    mpq_clears(value, best, NULL);
}

Test(cycling, ends_by_blands_rule, .timeout = 30)
{
    for (size_t i = 0; i < sizeof PROGRAMS / sizeof *PROGRAMS; i++) {
        solve_program(&PROGRAMS[i], false);
        solve_program(&PROGRAMS[i], true);
    }
}
