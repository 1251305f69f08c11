/* bench.c: see bench.h. */
#include "bench.h"

#include <criterion/criterion.h>
#include <string.h>

void bench_open(bench *b, int n)
{
    fmb_options o = {.size = sizeof o};
    *b = (bench){0};
    b->e.n = n;
    b->how =
        (fmb_elim_options){.order = FMB_ORDER_GIVEN, .steps = FMB_STEP_EQUALITIES, .rule = b->rule};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_arena_init(&b->arena, &b->mem);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
}

void bench_use(bench *b, const fmb_rule *rule)
{
    b->rule[b->how.rules++] = rule;
}

void bench_start(bench *b)
{
    cr_assert_eq(fmb_elim_init(&b->e, &b->run, &b->arena, b->e.n, &b->how), FMB_OK);
}

void bench_close(bench *b)
{
    fmb_elim_clear(&b->e);
    fmb_arena_clear(&b->arena);
    cr_assert_eq(b->mem.used, 0);
}

void bench_add(bench *b, const int64_t *row, fmb_rel rel)
{
    int64_t words[BENCH_DIM + 1];
    fmb_vec v = {.s = words};
    memcpy(words, row, ((size_t)b->e.n + 1) * sizeof *row);
    fmb_vec_measure(&v, (size_t)b->e.n + 1);
    cr_assert_eq(fmb_elim_add(&b->e, &v, rel), FMB_OK);
}

void bench_eliminate(bench *b, int n)
{
    bool drop[BENCH_DIM];
    for (int j = 0; j < b->e.n; j++)
        drop[j] = j < n;
    cr_assert_eq(fmb_elim_eliminate(&b->e, drop), FMB_OK);
}

void bench_prune(bench *b)
{
    cr_assert_eq(fmb_elim_prune(&b->e), FMB_OK);
}

void bench_add_octahedron(bench *b)
{
    for (int signs = 0; signs < 1 << b->e.n; signs++) {
        int64_t row[BENCH_DIM + 1];
        for (int j = 0; j < b->e.n; j++)
            row[j] = signs >> j & 1 ? -1 : 1;
        row[b->e.n] = 1;
        bench_add(b, row, FMB_LE);
    }
}

void bench_add_sheared_cube(bench *b)
{
    for (int j = 0; j < b->e.n; j++)
        for (int sign = -1; sign <= 1; sign += 2) {
            int64_t row[BENCH_DIM + 1] = {0};
            row[j] = sign;
            if (j + 1 < b->e.n)
                row[j + 1] = -sign;
            row[b->e.n] = 1;
            bench_add(b, row, FMB_LE);
        }
}
