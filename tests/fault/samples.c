/* samples.c: see samples.h. */
#include "samples.h"

#include "property/random/rows.h"

#define DIM  4
#define ROWS 8

/* Row: coefficients, relation, right side. */
typedef struct row {
    int a[DIM], rel, b;
} row;

static const row TABLE[][ROWS] = {
    /* bounded, with a strict row, an equality and a duplicate */
    {{{1, 1, 0, 0}, FMB_LE, 4},
     {{-1, 0, 0, 0}, FMB_LE, 0},
     {{0, -1, 0, 0}, FMB_LT, 0},
     {{1, -1, 1, 0}, FMB_EQ, 1},
     {{2, 2, 0, 0}, FMB_LE, 8},
     {{0, 0, 1, 1}, FMB_LE, 9},
     {{0, 0, 0, -1}, FMB_LE, 2},
     {{1, 0, -1, 3}, FMB_LE, 7}},
    /* infeasible */
    {{{-1, 0, 0, -1}, FMB_LE, -1},
     {{1, -1, 1, -1}, FMB_LE, 1},
     {{0, 1, 0, 1}, FMB_LE, 1},
     {{1, -1, 0, 1}, FMB_LE, 1},
     {{1, 1, 0, 0}, FMB_LE, -1},
     {{0, -1, -1, 1}, FMB_LE, -1},
     {{-1, 1, 1, 0}, FMB_LE, -1},
     {{0, 0, 0, 0}, FMB_LE, 1}},
    /* two components, unbounded, an equality in disguise */
    {{{1, -1, 0, 0}, FMB_LE, 3},
     {{-1, 1, 0, 0}, FMB_LE, -3},
     {{1, 1, 0, 0}, FMB_LE, 10},
     {{0, 0, 2, 3}, FMB_LT, 5},
     {{0, 0, -1, 4}, FMB_LE, 5},
     {{0, 0, 1, -1}, FMB_LE, 6},
     {{0, 0, 1, -2}, FMB_LE, 60},
     {{0, 0, 0, 1}, FMB_LE, 100}},
    /* the projection on two variables lacks a corner, and no facet */
    {{{-1, 0, 0, 0}, FMB_LE, 0},
     {{0, 0, -1, 0}, FMB_LE, 0},
     {{-1, 0, -3, 1}, FMB_LT, 0},
     {{0, 0, 0, -1}, FMB_LE, 0},
     {{1, 1, 1, 0}, FMB_LE, 9},
     {{0, -1, 0, 0}, FMB_LE, 0},
     {{0, 1, 0, 1}, FMB_LE, 3},
     {{2, 0, 2, 0}, FMB_LE, 18}},
};

enum { TABLES = sizeof TABLE / sizeof *TABLE };

/* The tables, and the tables once more with numbers near 2^200. */
int samples_count(void)
{
    return 2 * TABLES;
}

static void add_wide(fmb_system *s, const row *r)
{
    int var[DIM];
    mpq_t coef[DIM], b;
    mpq_init(b);
    for (int j = 0; j < DIM; j++) {
        var[j] = j;
        mpq_init(coef[j]);
        mpq_set_si(coef[j], r->a[j], 3);
        mpq_canonicalize(coef[j]);
        mpq_mul_2exp(coef[j], coef[j], 200);
    }
    mpq_set_si(b, r->b, 1);
    must(fmb_system_add_q(s, DIM, var, coef, (fmb_rel)r->rel, b));
    for (int j = 0; j < DIM; j++)
        mpq_clear(coef[j]);
    mpq_clear(b);
}

fmb_system *sample(int i, const fmb_alloc *mem)
{
    fmb_system *s = NULL;
    must(fmb_system_new(DIM, mem, &s));
    for (int k = 0; k < ROWS; k++) {
        const row *r = &TABLE[i % TABLES][k];
        int64_t a[DIM];
        for (int j = 0; j < DIM; j++)
            a[j] = r->a[j];
        if (i < TABLES)
            must(fmb_system_add_int(s, a, (fmb_rel)r->rel, r->b));
        else
            add_wide(s, r);
    }
    return s;
}

fmb_system *sample_hard(int n, int m, const fmb_alloc *mem)
{
    fmb_system *s = NULL;
    uint64_t seed = 1;
    must(fmb_system_new(n, mem, &s));
    for (int i = 0; i < m; i++) {
        int64_t a[64] = {0};
        for (int j = 0; j < n; j++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            a[j] = (int64_t)(seed >> 33) % 19 - 9;
        }
        must(fmb_system_add_int(s, a, FMB_LE, 5 + i));
    }
    return s;
}
