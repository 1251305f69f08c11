/* dominated.c: of parallel rows the tightest is kept, whatever their size. */
#include <criterion/criterion.h>

#include <fmb/gmp.h>

#include "bench.h"
#include "support.h"

static void open_dominated(bench *b, int n)
{
    bench_open(b, n);
    bench_use(b, fmb_rule_find("dominated"));
    bench_start(b);
}

Test(dominated, the_tightest_is_left)
{
    bench b;
    open_dominated(&b, 2);
    bench_add(&b, (int64_t[]){2, 2, 3}, FMB_LE);
    bench_add(&b, (int64_t[]){1, 1, 1}, FMB_LE);
    bench_add(&b, (int64_t[]){-1, -1, 0}, FMB_LE);
    bench_prune(&b);
    cr_assert_eq(b.e.live.size, 2);
    cr_expect(b.e.live.row[0] == 1 && b.e.live.row[1] == 2);
    bench_close(&b);
}

/* Of equal bounds a strict one; x + y < 3/2 loses to x + y <= 1. */
Test(dominated, strict_rows)
{
    bench b;
    open_dominated(&b, 2);
    bench_add(&b, (int64_t[]){2, 2, 3}, FMB_LT);
    bench_add(&b, (int64_t[]){1, 1, 1}, FMB_LE);
    bench_add(&b, (int64_t[]){3, 3, 3}, FMB_LT);
    bench_add(&b, (int64_t[]){5, 5, 5}, FMB_LE);
    bench_prune(&b);
    cr_assert_eq(b.e.live.size, 1);
    cr_expect_eq(b.e.live.row[0], 2);
    bench_close(&b);
}

/* ---- rows of any size ------------------------------------------------------------------------ */

/* The row s (x - y) REL b with s = 2^bits + odd. */
static void add_wide(bench *b, unsigned long bits, unsigned long odd, fmb_rel rel,
                     const char *right)
{
    mpz_t z[3];
    int64_t words[3];
    fmb_vec v = {.s = words};
    for (int j = 0; j < 3; j++)
        mpz_init(z[j]);
    mpz_ui_pow_ui(z[0], 2, bits);
    mpz_add_ui(z[0], z[0], odd);
    mpz_neg(z[1], z[0]);
    cr_assert_eq(mpz_set_str(z[2], right, 10), 0);
    cr_assert_eq(fmb_vec_set_z(&v, 3, z, &b->mem), FMB_OK);
    cr_assert_eq(fmb_elim_add(&b->e, &v, rel), FMB_OK);
    fmb_vec_clear(&v, 3, &b->mem);
    for (int j = 0; j < 3; j++)
        mpz_clear(z[j]);
}

/* Small rows and wide ones have the same direction and so meet; 2^70 (x - y) <= 2^69 - 1 is a bit
 * tighter than x - y <= 1/2. */
Test(dominated, small_beside_wide)
{
    bench b;
    open_dominated(&b, 2);
    bench_add(&b, (int64_t[]){2, -2, 1}, FMB_LE);
    add_wide(&b, 70, 0, FMB_LE, "590295810358705651711");
    add_wide(&b, 70, 0, FMB_LE, "590295810358705651713");
    bench_add(&b, (int64_t[]){-2, 2, 5}, FMB_LE);
    bench_prune(&b);
    cr_assert_eq(b.e.live.size, 2);
    cr_expect(b.e.live.row[0] == 1 && b.e.live.row[1] == 3);
    bench_close(&b);
}

/* Wide beside wide, equal bounds: 3 (2^80 + 1) (x - y) < 3 against (2^80 + 1) (x - y) <= 1. */
Test(dominated, wide_beside_wide)
{
    bench b;
    open_dominated(&b, 2);
    add_wide(&b, 80, 1, FMB_LE, "1");
    add_wide(&b, 80, 1, FMB_LT, "1");
    add_wide(&b, 80, 3, FMB_LE, "-7");
    bench_prune(&b);
    cr_assert_eq(b.e.live.size, 1, "all three bound x - y");
    cr_expect_eq(b.e.live.row[0], 2);
    bench_close(&b);
}

/* The same random rows small and as GMP: what is left is the same, and is what comparing each row
 * with each says. */
static void add_random(bench *b, support_rng *g, int64_t (*row)[4], bool *strict)
{
    for (int i = 0; i < 24; i++) {
        int64_t scale = support_between(g, 1, 3);
        for (int j = 0; j < 3; j++)
            row[i][j] = scale * support_between(g, -1, 1);
        row[i][0] = row[i][1] == 0 && row[i][2] == 0 ? scale : row[i][0];
        row[i][3] = support_between(g, -2, 2);
        strict[i] = support_chance(g, 30);
        bench_add(b, row[i], strict[i] ? FMB_LT : FMB_LE);
    }
}

static int64_t size_of(const int64_t *row)
{
    int64_t most = 0;
    for (int j = 0; j < 3; j++)
        most = llabs(row[j]) > most ? llabs(row[j]) : most;
    return most;
}

/* Does row k make row i superfluous? Entries are -s, 0, s: parallel rows differ in s only. */
static bool beats(int64_t (*row)[4], const bool *strict, int k, int i)
{
    int64_t s = size_of(row[k]), t = size_of(row[i]);
    for (int j = 0; j < 3; j++)
        if (row[k][j] * t != row[i][j] * s)
            return false;
    int64_t left = row[k][3] * t, right = row[i][3] * s;
    if (left != right)
        return left < right;
    return strict[k] != strict[i] ? strict[k] : k < i;
}

Test(dominated, random_rows)
{
    for (uint64_t seed = 0; seed < 200; seed++) {
        size_t left[2];
        for (int wide = 0; wide < 2; wide++) {
            support_rng g = {seed};
            int64_t row[24][4];
            bool strict[24];
            bench b;
            bench_open(&b, 3);
            b.how.wide_only = wide;
            bench_use(&b, fmb_rule_find("dominated"));
            bench_start(&b);
            add_random(&b, &g, row, strict);
            bench_prune(&b);
            for (int i = 0; i < 24; i++) {
                bool beaten = false, alive = false;
                for (int k = 0; k < 24; k++)
                    beaten |= k != i && beats(row, strict, k, i);
                for (size_t k = 0; k < b.e.live.size; k++)
                    alive |= b.e.live.row[k] == (uint32_t)i;
                cr_expect_neq(beaten, alive, "seed %d, row %d", (int)seed, i);
            }
            left[wide] = b.e.live.size;
            bench_close(&b);
        }
        cr_expect_eq(left[0], left[1]);
    }
}
