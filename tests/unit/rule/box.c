/* box.c: rows that hold strictly in all of the box are dropped; rows that touch it only before the
 * first round. */
#include <criterion/criterion.h>

#include "bench.h"
#include "cuboids.h"
#include "elim/round/round.h"

static void open_square(bench *b)
{
    bench_open(b, 2);
    b->how.steps |= FMB_STEP_BOUNDS;
    bench_use(b, fmb_rule_find("box"));
    bench_start(b);
    for (int j = 0; j < 2; j++) {
        bench_add(b, (int64_t[]){j == 0, j == 1, 1}, FMB_LE);
        bench_add(b, (int64_t[]){-(j == 0), -(j == 1), 0}, FMB_LE);
    }
}

/* Is row 4, a.x REL b, still there when the first round begins? */
static bool stays(const int64_t *row, fmb_rel rel)
{
    bench b;
    bool alive = false;
    open_square(&b);
    bench_add(&b, row, rel);
    cr_assert_eq(fmb_elim_start_histories(&b.e), FMB_OK);
    for (size_t i = 0; i < b.e.live.size; i++)
        alive |= b.e.live.row[i] == 4;
    bench_close(&b);
    return alive;
}

Test(box, strictly_slack_rows_go)
{
    cr_expect(!stays((int64_t[]){1, 1, 3}, FMB_LT));
    cr_expect(!stays((int64_t[]){1, 1, 3}, FMB_LE));
    cr_expect(!stays((int64_t[]){1, 1, 2}, FMB_LE), "before histories start");
    cr_expect(stays((int64_t[]){1, 1, 2}, FMB_LT));
    cr_expect(!stays((int64_t[]){-1, -1, 1}, FMB_LE));
    cr_expect(stays((int64_t[]){-1, -1, 0}, FMB_LT));
    cr_expect(!stays((int64_t[]){1, -1, 2}, FMB_LE));
    cr_expect(stays((int64_t[]){1, -1, 1}, FMB_LT));
}

/* An end that is missing, or a half: 2x <= 1 in place of x <= 1. */
Test(box, other_boxes)
{
    for (int half = 0; half < 2; half++) {
        bench b;
        bench_open(&b, 2);
        b.how.steps |= FMB_STEP_BOUNDS;
        bench_use(&b, fmb_rule_find("box"));
        bench_start(&b);
        bench_add(&b, (int64_t[]){1 + half, 0, 1}, FMB_LE);
        bench_add(&b, (int64_t[]){0, 3, 1}, FMB_LE);
        bench_add(&b, (int64_t[]){6, 6, 6}, FMB_LE);
        bench_add(&b, (int64_t[]){-1, 1, 100}, FMB_LE);
        cr_assert_eq(fmb_elim_start_histories(&b.e), FMB_OK);
        cr_expect_eq(b.e.live.size, half ? 3 : 4, "1/2 + 1/3 < 1 < 1 + 1/3; x has no lower end");
        bench_close(&b);
    }
}

/* Numbers that fit no word: 2^200 (x + y) <= 2^201 + 1 is slack, and with 2^201 it touches. */
Test(box, wide_rows)
{
    for (int slack = 0; slack < 2; slack++) {
        mpz_t z[3];
        int64_t words[3];
        fmb_vec v = {.s = words};
        bench b;
        open_square(&b);
        for (int j = 0; j < 3; j++)
            mpz_init(z[j]);
        mpz_ui_pow_ui(z[0], 2, 200);
        mpz_set(z[1], z[0]);
        mpz_ui_pow_ui(z[2], 2, 201);
        mpz_add_ui(z[2], z[2], (unsigned long)slack);
        cr_assert_eq(fmb_vec_set_z(&v, 3, z, &b.mem), FMB_OK);
        cr_assert_eq(fmb_elim_add(&b.e, &v, FMB_LT), FMB_OK);
        fmb_vec_clear(&v, 3, &b.mem);
        for (int j = 0; j < 3; j++)
            mpz_clear(z[j]);
        cr_assert_eq(fmb_elim_start_histories(&b.e), FMB_OK);
        cr_expect_eq(b.e.live.size, slack ? 4 : 5);
        bench_close(&b);
    }
}

Test(box, moving_cuboids)
{
    double without = cuboids_rows_made("chernikov", NULL);
    double with = cuboids_rows_made("chernikov,box", NULL);
    cr_expect(59 < without && without < 60, "%g rows without", without);
    cr_expect(26 < with && with < 27, "%g rows with it", with);
}
