/* vertex.c: signs of slacks at vertices, and refutations by bases, at the ends of doubles: never
 * wrong, whatever underflows. */
#include <criterion/criterion.h>

#include "lp/oracle/refined_farkas.h"
#include "vertex_bench.h"

/* (a 2^ea + odd) x + c 2^ec y rel d: odd, so that the powers of two are not divided away. */
static void add_row(vertex_bench *b, const int a[2], int odd, const int c[2], int d, fmb_rel rel)
{
    mpz_t z[3];
    mpz_init_set_si(z[0], a[0]);
    mpz_init_set_si(z[1], c[0]);
    mpz_init_set_si(z[2], d);
    mpz_mul_2exp(z[0], z[0], (mp_bitcnt_t)a[1]);
    mpz_add_ui(z[0], z[0], (unsigned long)odd);
    mpz_mul_2exp(z[1], z[1], (mp_bitcnt_t)c[1]);
    cr_assert_eq(fmb_program_add_integers(&b->p, z, rel), FMB_OK);
    for (int k = 0; k < 3; k++)
        mpz_clear(z[k]);
}

static void stand_on_first_rows(vertex_bench *b)
{
    vertex_bench_stand(b);
    cr_assert_eq(fmb_vertex_set(&b->v, (const size_t[]){0, 1}), FMB_OK);
    cr_assert_eq(fmb_vertex_solve(&b->v), FMB_OK);
}

/* x = 1.5 and y = 1.25 times 2^e, and 10 x - 19 y <= 0, which holds, or >= 0, times 2^k. As doubles
 * at e = -1074 these are 2 and 1. */
static void check_row_at(int e, int k, bool holds)
{
    vertex_bench b;
    size_t row;
    int sign;
    vertex_bench_open(&b);
    add_row(&b, (const int[]){1, 1 - e}, 0, (const int[]){0, 0}, 3, FMB_EQ);
    add_row(&b, (const int[]){0, 0}, 0, (const int[]){1, 2 - e}, 5, FMB_EQ);
    if (holds)
        add_row(&b, (const int[]){10, k}, 1, (const int[]){-19, k}, 0, FMB_LE);
    else
        add_row(&b, (const int[]){-10, k}, 1, (const int[]){19, k}, 0, FMB_LE);
    stand_on_first_rows(&b);
    cr_assert_eq(fmb_vertex_find_violated(&b.v, true, &row, &sign), FMB_OK);
    cr_assert_eq(row, holds ? SIZE_MAX : 2, "2^%d, 2^%d", e, k);
    vertex_bench_close(&b);
}

Test(vertex, slacks_where_coordinates_underflow)
{
    for (int e = -1060; e >= -1090; e--)
        for (int k = 100; k <= 1000; k += 100) {
            check_row_at(e, k, true);
            check_row_at(e, k, false);
        }
    for (int k = 100; k <= 3000; k += 100) {
        check_row_at(-2100, k, true);
        check_row_at(-2100, k, false);
    }
}

/* x + 2^far y <= 0 and x - 2^far y <= 0 against x >= d: a contradiction if d > 0. With turn = -1
 * they say x >= 0, and multipliers have the wrong signs. */
static void check_refutation(int turn, int far, int d)
{
    vertex_bench b;
    int sign;
    bool sure, wanted = turn > 0 && d > 0;
    vertex_bench_open(&b);
    add_row(&b, (const int[]){turn * 2, 0}, 0, (const int[]){1, far + 1}, 0, FMB_LE);
    add_row(&b, (const int[]){turn * 2, 0}, 0, (const int[]){-1, far + 1}, 0, FMB_LE);
    add_row(&b, (const int[]){-1, 0}, 0, (const int[]){0, 0}, -d, FMB_LE);
    stand_on_first_rows(&b);
    cr_assert_eq(fmb_refined_farkas(&b.v, 2, &sign, &sure), FMB_OK);
    cr_assert(!sure || wanted, "%d, 2^%d, %d", turn, far, d);
    cr_assert(sure || !wanted || far > 120, "2^%d, %d", far, d);
    vertex_bench_close(&b);
}

Test(vertex, refutations)
{
    for (int far = 0; far <= 1200; far += 60)
        for (int d = -2; d <= 2; d++) {
            check_refutation(1, far, d);
            check_refutation(-1, far, d);
        }
}
