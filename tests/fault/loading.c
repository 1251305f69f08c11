/* loading.c: what a large matrix costs on its way in and out, counted: blocks of memory in
 * proportion to its rows, and nothing of GMP's, so that its cost is that of copying it.
 */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gmp.h>

#include <fmb/fmb.h>

#include "hook.h"

enum { ROWS = 20000, DIM = 100, TERMS = 3 };

/* ---- what GMP asks for ----------------------------------------------------------------------- */

static size_t limbs; /* blocks that GMP has asked for */

static void *get(size_t n)
{
    limbs++;
    return malloc(n);
}

static void *resize(void *p, size_t old_bytes, size_t new_bytes)
{
    (void)old_bytes;
    limbs++;
    return realloc(p, new_bytes);
}

static void put(void *p, size_t n)
{
    (void)n;
    free(p);
}

/* ---- a matrix -------------------------------------------------------------------------------- */

typedef struct matrix {
    size_t start[ROWS + 1];
    int var[TERMS * ROWS];
    double coef[TERMS * ROWS], b[ROWS];
    int64_t whole[TERMS * ROWS], right[ROWS];
    fmb_rel rel[ROWS];
} matrix;

static matrix in, out;

/* Numbers with so many bits behind the point; relations of all kinds. */
static void fill_matrix(int bits)
{
    for (size_t i = 0; i < ROWS; i++) {
        in.start[i + 1] = in.start[i] + TERMS;
        for (size_t k = 0; k < TERMS; k++) {
            size_t at = TERMS * i + k;
            in.var[at] = (int)(i % (DIM - 2 * TERMS) + 2 * k);
            in.whole[at] = (int64_t)(i + 3 * k) - ROWS / 2;
            in.whole[at] += in.whole[at] == 0; /* zeros are not kept */
            in.coef[at] = ldexp((double)in.whole[at], -bits);
        }
        in.right[i] = (int64_t)i - 7;
        in.b[i] = ldexp((double)in.right[i], -bits);
        in.rel[i] = (fmb_rel)(i % 3);
    }
}

static void expect_same(const void *a, const void *b, size_t bytes, const char *what)
{
    cr_expect(memcmp(a, b, bytes) == 0, "%s came out otherwise", what);
}

/* Two blocks a row, variables and numbers; the table of rows, which doubles; and a few more. */
static void expect_few_blocks(const hook *h, const char *what)
{
    size_t doublings = 8 * sizeof(size_t);
    cr_expect_leq(h->calls, 2 * (size_t)ROWS + doublings, "%s: %zu blocks", what, h->calls);
    cr_expect_eq(limbs, 0, "%s: %zu blocks of GMP's", what, limbs);
}

static fmb_system *open_space(hook *h)
{
    fmb_system *s = NULL;
    fmb_alloc mem = hook_alloc(h);
    cr_assert_eq(fmb_system_new(DIM, &mem, &s), FMB_OK);
    hook_arm(h, 0, false);
    limbs = 0;
    mp_set_memory_functions(get, resize, put);
    return s;
}

Test(loading, doubles)
{
    const int bits[] = {0, 10, 40};
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++) {
        hook h = {0};
        fill_matrix(bits[i]);
        fmb_system *s = open_space(&h);
        cr_assert_eq(fmb_system_add_rows(s, ROWS, in.start, in.var, in.coef, in.rel, in.b), FMB_OK);
        expect_few_blocks(&h, "in");
        hook_arm(&h, 0, false);
        cr_assert_eq(fmb_system_get_rows(s, 0, ROWS, out.start, out.var, out.coef, out.rel, out.b),
                     FMB_OK);
        cr_expect_eq(h.calls + limbs, 0, "out: %zu blocks", h.calls + limbs);
        expect_same(in.start, out.start, sizeof in.start, "starts");
        expect_same(in.var, out.var, sizeof in.var, "variables");
        expect_same(in.coef, out.coef, sizeof in.coef, "coefficients");
        expect_same(in.rel, out.rel, sizeof in.rel, "relations");
        expect_same(in.b, out.b, sizeof in.b, "right sides");
        fmb_system_free(s);
        cr_expect_eq(h.live, 0);
    }
}

Test(loading, integers)
{
    hook h = {0};
    fill_matrix(0);
    fmb_system *s = open_space(&h);
    cr_assert_eq(fmb_system_add_rows_int(s, ROWS, in.start, in.var, in.whole, in.rel, in.right),
                 FMB_OK);
    expect_few_blocks(&h, "in");
    hook_arm(&h, 0, false);
    cr_assert_eq(
        fmb_system_get_rows_int(s, 0, ROWS, out.start, out.var, out.whole, out.rel, out.right),
        FMB_OK);
    cr_expect_eq(h.calls + limbs, 0, "out: %zu blocks", h.calls + limbs);
    expect_same(in.whole, out.whole, sizeof in.whole, "coefficients");
    expect_same(in.right, out.right, sizeof in.right, "right sides");
    fmb_system_free(s);
    cr_expect_eq(h.live, 0);
}

/* Points and directions come out without GMP, too. */
Test(loading, generators)
{
    enum { POINTS = 1000 };
    static double x[POINTS * DIM];
    static fmb_generator_kind kind[POINTS];
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_generators *g = NULL;
    fill_matrix(10);
    cr_assert_eq(fmb_generators_new(DIM, &mem, &g), FMB_OK);
    for (size_t i = 0; i < POINTS; i++)
        cr_assert_eq(fmb_generators_add(g, i % 2 ? FMB_RAY : FMB_VERTEX, &in.coef[i]), FMB_OK);
    hook_arm(&h, 0, false);
    limbs = 0;
    mp_set_memory_functions(get, resize, put);
    cr_assert_eq(fmb_generators_get(g, 0, POINTS, kind, x), FMB_OK);
    cr_expect_eq(h.calls + limbs, 0, "out: %zu blocks", h.calls + limbs);
    for (size_t i = 0; i < POINTS; i++) {
        bool is_ray = i % 2; /* whose length is free: here its numbers are made whole */
        double factor = is_ray ? x[i * DIM] / in.coef[i] : 1;
        cr_assert_eq(kind[i], is_ray ? FMB_RAY : FMB_VERTEX);
        for (size_t j = 0; j < DIM; j++)
            cr_assert_eq(x[i * DIM + j], factor * in.coef[i + j]);
    }
    fmb_generators_free(g);
    cr_expect_eq(h.live, 0);
}
