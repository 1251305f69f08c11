/* ends.c: the end of an elimination: bounds that touch, limits, and simple numbers between bounds.
 * Rules are tested in tests/unit/rule. */
#include <criterion/criterion.h>

#include "elim/round/witness.h"
#include "unit/rule/bench.h"

Test(elim, strict_bounds_that_touch_clash)
{
    for (int strict = 0; strict < 2; strict++) {
        bench b;
        bench_open(&b, 1);
        bench_start(&b);
        bench_add(&b, (int64_t[]){2, 6}, FMB_LE);
        bench_add(&b, (int64_t[]){1, 3}, strict ? FMB_LT : FMB_LE);
        bench_add(&b, (int64_t[]){-5, -15}, FMB_LE);
        bench_eliminate(&b, 1);
        cr_assert_eq(b.e.clash != FMB_NO_ROW, strict);
        bench_close(&b);
    }
}

/* As many rows as the limit says may live, and not one more. */
Test(elim, the_limit_on_rows_is_met_to_the_row)
{
    size_t peak = 0;
    for (int less = -1; less <= 1; less++) { /* -1: no limit */
        bool drop[] = {true, true, true, false};
        bench b;
        bench_open(&b, 4);
        bench_start(&b);
        bench_add_octahedron(&b);
        b.run.max_rows = less < 0 ? 0 : peak - (size_t)less;
        fmb_status st = fmb_elim_eliminate(&b.e, drop);
        cr_assert_eq(st, less > 0 ? FMB_LIMIT : FMB_OK, "%d less", less);
        cr_assert_eq(b.run.stop, less > 0 ? FMB_STOP_ROWS : FMB_STOP_DONE);
        if (less < 0)
            peak = b.run.stats.rows_peak;
        cr_assert(peak > 16 && b.run.stats.rows_peak == peak);
        bench_close(&b);
    }
}

Test(witness, simple_numbers_first)
{
    static const struct {
        int lower, lower_den, lower_open, upper, upper_den, upper_open, num, den;
    } cases[] = {
        {-3, 2, 0, 5, 1, 0, 0, 1},   {1, 2, 0, 5, 1, 0, 1, 1},    {1, 1, 1, 5, 1, 0, 2, 1},
        {1, 3, 0, 1, 2, 0, 1, 3},    {1, 3, 1, 1, 2, 1, 5, 12},   {-7, 2, 0, -5, 2, 0, -3, 1},
        {-1, 2, 0, -1, 3, 0, -1, 3}, {-2, 1, 0, -1, 1, 1, -2, 1}, {0, 1, 1, 1, 1, 1, 1, 2},
        {3, 7, 0, 3, 7, 0, 3, 7},
    };
    mpq_t lower, upper, x;
    mpq_inits(lower, upper, x, NULL);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mpq_set_si(lower, cases[i].lower, (unsigned long)cases[i].lower_den);
        mpq_set_si(upper, cases[i].upper, (unsigned long)cases[i].upper_den);
        fmb_simple_between(x, lower, cases[i].lower_open, upper, cases[i].upper_open);
        cr_assert_eq(mpq_cmp_si(x, cases[i].num, (unsigned long)cases[i].den), 0, "case %zu", i);
    }
    mpq_set_si(lower, 5, 2);
    fmb_simple_between(x, lower, false, NULL, false);
    cr_assert_eq(mpq_cmp_si(x, 3, 1), 0);
    mpq_set_si(upper, -5, 2);
    fmb_simple_between(x, NULL, false, upper, true);
    cr_assert_eq(mpq_cmp_si(x, -3, 1), 0);
    mpq_clears(lower, upper, x, NULL);
}
