/* duplicate.c: of equal rows one is kept, the strict one. */
#include <criterion/criterion.h>

#include "bench.h"

Test(duplicate, one_is_left_the_strict_one)
{
    bench b;
    bench_open(&b, 2);
    bench_use(&b, fmb_rule_find("duplicate"));
    bench_start(&b);
    bench_add(&b, (int64_t[]){1, 1, 1}, FMB_LE);
    bench_add(&b, (int64_t[]){2, 2, 2}, FMB_LE);
    bench_add(&b, (int64_t[]){1, 1, 1}, FMB_LT);
    bench_prune(&b);
    cr_assert_eq(b.e.live.size, 1);
    cr_expect_eq(b.e.live.row[0], 2);
    bench_close(&b);
}

/* Equal rows made by combination. */
Test(duplicate, after_a_round)
{
    bench b;
    bench_open(&b, 2);
    bench_use(&b, fmb_rule_find("duplicate"));
    bench_start(&b);
    bench_add(&b, (int64_t[]){1, 1, 1}, FMB_LE);
    bench_add(&b, (int64_t[]){2, 2, 2}, FMB_LT);
    bench_add(&b, (int64_t[]){-1, 0, 0}, FMB_LE);
    bench_eliminate(&b, 1);
    cr_assert_eq(b.e.live.size, 1, "both pairs give x2 <= 1, once strictly");
    cr_expect(b.e.row[b.e.live.row[0]].strict);
    bench_close(&b);
}

/* Opposite rows, other right sides and equalities are not equal. */
Test(duplicate, others_stay)
{
    bench b;
    bench_open(&b, 2);
    bench_use(&b, fmb_rule_find("duplicate"));
    bench_start(&b);
    bench_add(&b, (int64_t[]){1, 1, 1}, FMB_LE);
    bench_add(&b, (int64_t[]){-1, -1, -1}, FMB_LE);
    bench_add(&b, (int64_t[]){1, 1, 2}, FMB_LE);
    bench_add(&b, (int64_t[]){1, 1, 1}, FMB_EQ);
    bench_add(&b, (int64_t[]){1, -1, 1}, FMB_LE);
    bench_prune(&b);
    cr_expect_eq(b.e.live.size, 5);
    bench_close(&b);
}
