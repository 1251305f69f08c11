/* ends.c: bounds of variables by propagation: of equal bounds the strict one counts, and a derived
 * bound is strict by strict bounds of other variables, not of its own. */
#include <criterion/criterion.h>

#include "elim/round/elim.h"
#include "solve/limit/outer_ends.h"

enum { COLUMNS = 2, X = 0, Y = 1 };

static const struct {
    int64_t words[COLUMNS + 1];
    fmb_rel rel;
} ROW[] = {
    {{-1, 0, 0}, FMB_LT},  /* 0: x > 0 */
    {{1, 0, 4}, FMB_LE},   /* 1: x <= 4 */
    {{0, -1, -1}, FMB_LE}, /* 2: y >= 1 */
    {{0, 1, 5}, FMB_LE},   /* 3: y <= 5 */
    {{1, 1, 5}, FMB_LE},   /* 4: x + y <= 5, so x <= 4 once more, and y < 5 */
};

Test(ends, own_strict_end)
{
    fmb_options o = {.size = sizeof o};
    fmb_elim_options how = {.order = FMB_ORDER_PAIRS};
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_arena arena;
    fmb_run run;
    fmb_elim e;
    fmb_ends f;
    const size_t rows = sizeof ROW / sizeof *ROW;
    fmb_mem_init(&mem, NULL, 0);
    fmb_arena_init(&arena, &mem);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    cr_assert_eq(fmb_elim_init(&e, &run, &arena, COLUMNS, &how), FMB_OK);
    for (size_t i = 0; i < rows; i++) {
        int64_t words[COLUMNS + 1];
        fmb_vec v = {.s = words};
        for (int j = 0; j <= COLUMNS; j++)
            words[j] = ROW[i].words[j];
        fmb_vec_measure(&v, COLUMNS + 1);
        cr_assert_eq(fmb_elim_add(&e, &v, ROW[i].rel), FMB_OK);
    }
    cr_assert_eq(fmb_ends_open(&f, &e), FMB_OK);
    cr_assert_eq(fmb_ends_find(&f), FMB_OK);
    cr_expect_eq(f.row[FMB_LOWER][X], 0);
    cr_expect_eq(f.row[FMB_UPPER][X], 1, "x <= 4 is as good as what x + y <= 5 says");
    cr_expect_eq(f.row[FMB_LOWER][Y], 2);
    cr_expect(f.row[FMB_UPPER][Y] >= rows && e.row[f.row[FMB_UPPER][Y]].strict,
              "y < 5 is better than y <= 5");
    cr_expect_eq(e.rows, rows + 1);
    fmb_ends_clear(&f);
    fmb_elim_clear(&e);
    fmb_arena_clear(&arena);
    cr_expect_eq(mem.used, 0);
}
