/* sorting.c: rows sorted by guesses: the oracle is asked whether there is a solution as soon as a
 * glance finds no point inside, and not where one is known. */
#include <criterion/criterion.h>

#include "lp/redundancy/implied.h"

enum { ROWS = 4 };

/* The square 0 <= x, y with x <= right, y <= top, whose rows are sorted. */
static fmb_stats sort_square(int64_t right, int64_t top, bool known, fmb_sorting *out)
{
    int64_t words[ROWS][3] = {{-1, 0, 0}, {1, 0, right}, {0, -1, 0}, {0, 1, top}};
    fmb_options o = fmb_options_default();
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_vec v[ROWS] = {{0}};
    fmb_lp_row row[ROWS];
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (size_t i = 0; i < ROWS; i++) {
        v[i].s = words[i];
        fmb_vec_measure(&v[i], 3);
        row[i] = (fmb_lp_row){&v[i], FMB_LE};
    }
    out->known = known;
    cr_assert_eq(fmb_lp_sort_rows(&run, 2, ROWS, row, out), FMB_OK);
    cr_expect_eq(mem.used, 0);
    return run.stats;
}

Test(sorting, asks_the_oracle_only_in_doubt)
{
    static const struct {
        int64_t right, top;
        bool known, inner, feasible;
        unsigned lps;
    } table[] = {
        {5, 7, false, true, true, 0},    /* a point inside is seen at once */
        {5, 7, true, true, true, 0},     /* */
        {5, 0, true, false, true, 0},    /* flat, and known to have a solution */
        {5, 0, false, false, true, 1},   /* flat: the oracle knows */
        {5, -3, false, false, false, 1}, /* empty: the oracle ends it */
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        bool gone[ROWS] = {0}, kept[ROWS] = {0};
        fmb_sorting out = {.gone = gone, .kept = kept};
        fmb_stats stats = sort_square(table[i].right, table[i].top, table[i].known, &out);
        cr_expect_eq(out.inner, table[i].inner, "%zu", i);
        cr_expect_eq(out.feasible, table[i].feasible, "%zu", i);
        cr_expect_eq(stats.lps, table[i].lps, "%zu: %lu", i, (unsigned long)stats.lps);
        for (size_t k = 0; k < ROWS; k++) {
            cr_expect(!gone[k]);
            cr_expect(kept[k] == table[i].inner, "%zu: row %zu", i, k);
        }
    }
}

/* The same square in two columns of so many that all of them together would be refused. */
Test(sorting, columns_that_no_row_names_do_not_count)
{
    enum { COLUMNS = 500, X = 17, Y = 400 };
    static int64_t words[ROWS][COLUMNS + 1];
    bool gone[ROWS] = {0}, kept[ROWS] = {0};
    fmb_sorting out = {.gone = gone, .kept = kept};
    for (size_t i = 0; i < ROWS; i++) {
        words[i][i < 2 ? X : Y] = i % 2 == 0 ? -1 : 1;
        words[i][COLUMNS] = i % 2 == 0 ? 0 : 5;
    }
    fmb_options o = fmb_options_default();
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run;
    fmb_vec v[ROWS] = {{0}};
    fmb_lp_row row[ROWS];
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (size_t i = 0; i < ROWS; i++) {
        v[i].s = words[i];
        fmb_vec_measure(&v[i], COLUMNS + 1);
        row[i] = (fmb_lp_row){&v[i], FMB_LE};
    }
    cr_assert_eq(fmb_lp_sort_rows(&run, COLUMNS, ROWS, row, &out), FMB_OK);
    cr_expect(out.inner);
    cr_expect_eq(out.doubtful, 0);
    for (size_t i = 0; i < ROWS; i++)
        cr_expect(kept[i] && !gone[i], "row %zu", i);
    cr_expect_eq(mem.used, 0);
}
