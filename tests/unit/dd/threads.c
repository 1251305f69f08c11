/* threads.c: the rays of a cone by several threads are those by one, in the same order. */
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
static void open_bench(bench *b, size_t threads, bool doubled)
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
    fmb_cone_problem of = {D, (size_t)rows, b->row, D, doubled ? NULL : b->keep, false, false};
    cr_assert_eq(fmb_cone_init(&b->cone, &b->run, &of), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_cone_clear(&b->cone);
    cr_assert_eq(b->mem.used, 0);
}

static void expect_same_rays(const fmb_cone *a, const fmb_cone *b)
{
    mpz_t x, y;
    mpz_inits(x, y, NULL);
    cr_assert_eq(a->ray.size, b->ray.size);
    for (size_t i = 0; i < a->ray.size; i++)
        for (size_t k = 0; k < D; k++) {
            fmb_vec_get(&a->ray.v[i], k, x);
            fmb_vec_get(&b->ray.v[i], k, y);
            cr_assert(mpz_cmp(x, y) == 0, "ray %zu", i);
        }
    mpz_clears(x, y, NULL);
}

static void check_threads(bool doubled, size_t least)
{
    static bench one, several;
    bool done;
    open_bench(&one, 1, doubled);
    cr_assert_eq(fmb_cone_run(&one.cone, 0, &done), FMB_OK);
    cr_assert(done && one.cone.ray.size >= least, "%zu", one.cone.ray.size);
    for (size_t threads = 2; threads <= 5; threads += 3) {
        open_bench(&several, threads, doubled);
        for (done = false; !done;)
            cr_assert_eq(fmb_cone_run(&several.cone, threads == 2 ? 0 : 1000, &done), FMB_OK);
        cr_assert(!doubled || several.cone.at->crew, "all was done by one thread");
        expect_same_rays(&one.cone, &several.cone);
        close_bench(&several);
    }
    close_bench(&one);
}

Test(cone_threads, simple)
{
    check_threads(false, 11440);
}

Test(cone_threads, degenerate)
{
    check_threads(true, 1000);
}

/* A limit on bytes ends it, whatever has been taken by then. */
Test(cone_threads, little_memory)
{
    static bench b;
    fmb_status st = FMB_OK;
    for (size_t bytes = 1 << 20; bytes < 1 << 23; bytes += bytes / 3) {
        bool done = false;
        open_bench(&b, 3, false);
        b.mem.limit = bytes;
        st = fmb_cone_run(&b.cone, 0, &done);
        cr_assert(st == FMB_LIMIT || (st == FMB_OK && done));
        close_bench(&b);
    }
}
