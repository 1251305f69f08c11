/* threads.c: the rays of a cone by several threads are those by one, in the same order; so are
 * their supports, and what is counted, wherever the work pauses. */
#include <criterion/criterion.h>

#include "dd/insert.h"

enum { D = 7, SIMPLE_ROWS = 44, ROWS = 64 };

typedef struct bench {
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    int64_t word[ROWS][D];
    fmb_vec v[ROWS];
    fmb_cone_row row[ROWS];
    size_t keep[D];
    fmb_cone cone;
} bench;

/* (1, t, t^2, ...) */
static void put_point(int64_t *x, int t)
{
    x[0] = 1;
    for (int k = 1; k < D; k++)
        x[k] = x[k - 1] * t;
}

/* That of t and t + 1, twice. */
static void put_middle(int64_t *x, int t)
{
    int64_t next[D];
    put_point(next, t + 1);
    for (int k = 0; k < D; k++)
        x[k] += next[k];
}

/* The facets of a cyclic polytope: most of all with so many vertices, and all simple. With
 * `doubled`, each second vertex is between its neighbours, which come behind all of those: rays are
 * not simple. */
static void open_bench(bench *b, size_t threads, bool doubled, bool wide)
{
    fmb_options o = fmb_options_default();
    int rows = doubled ? ROWS : SIMPLE_ROWS;
    *b = (bench){0};
    o.threads = threads;
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    for (int i = 0; i < rows; i++) {
        int t = doubled ? i % (rows / 2) - rows / 4 : i - rows / 2;
        put_point(b->word[i], t);
        if (doubled && i < rows / 2)
            put_middle(b->word[i], t);
        b->v[i] = (fmb_vec){.s = b->word[i]};
        fmb_vec_measure(&b->v[i], D);
        b->row[i] = (fmb_cone_row){.v = &b->v[i]};
    }
    for (size_t k = 0; k < D; k++)
        b->keep[k] = k;
    fmb_cone_problem of = {D, (size_t)rows, b->row, D, doubled ? NULL : b->keep, wide, false};
    cr_assert_eq(fmb_cone_init(&b->cone, &b->run, &of), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_cone_clear(&b->cone);
    cr_assert_eq(b->mem.used, 0);
}

static void expect_same_cones(const fmb_cone *a, const fmb_cone *b)
{
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    cr_assert_eq(a->ray.size, b->ray.size);
    cr_assert_eq(a->made, b->made);
    for (size_t i = 0; i < a->ray.size; i++) {
        for (size_t k = 0; k < D; k++) {
            fmb_vec_get(&a->ray.v[i], k, x);
            fmb_vec_get(&b->ray.v[i], k, y);
            cr_assert(mpz_cmp(x, y) == 0, "ray %zu", i);
        }
        for (size_t w = 0; w < a->ray.words; w++)
            cr_assert_eq(fmb_rays_support(&a->ray, i)[w], fmb_rays_support(&b->ray, i)[w]);
    }
    mpz_clears(x, y, NULL);
}

/* Both pause wherever they made so many rays more: at the same places. */
static void check_threads(size_t threads, uint64_t pause, bool doubled, bool wide)
{
    static bench one, several;
    bool done = false, also = false;
    open_bench(&one, 1, doubled, wide);
    open_bench(&several, threads, doubled, wide);
    while (!done) {
        cr_assert_eq(fmb_cone_run(&one.cone, pause, &done), FMB_OK);
        cr_assert_eq(fmb_cone_run(&several.cone, pause, &also), FMB_OK);
        cr_assert_eq(done, also);
        expect_same_cones(&one.cone, &several.cone);
    }
    cr_assert(one.cone.ray.size >= (doubled ? 1000 : 11440), "%zu", one.cone.ray.size);
    cr_assert(several.cone.at->crew, "all was done by one thread");
    close_bench(&several);
    close_bench(&one);
}

Test(cone_threads, simple)
{
    check_threads(2, 0, false, false);
    check_threads(3, 0, false, false);
    check_threads(7, 3000, false, false);
}

Test(cone_threads, degenerate)
{
    check_threads(2, 0, true, false);
    check_threads(3, 1000, true, false);
    check_threads(7, 0, true, false);
}

/* Wide rays count more: a batch may come to more than is due. */
Test(cone_threads, wide)
{
    check_threads(3, 20000, false, true);
}

/* A limit on bytes ends it, whatever has been taken by then. */
Test(cone_threads, little_memory)
{
    static bench b;
    fmb_status st = FMB_OK;
    for (size_t bytes = 1 << 20; bytes < 1 << 23; bytes += bytes / 3) {
        bool done = false;
        open_bench(&b, 3, false, false);
        b.mem.limit = bytes;
        st = fmb_cone_run(&b.cone, 0, &done);
        cr_assert(st == FMB_LIMIT || (st == FMB_OK && done));
        close_bench(&b);
    }
}
