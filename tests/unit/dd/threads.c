/* threads.c: several threads find the same facet normals as one thread, and the same rays of a cone
 * in the same order, with the same supports and counts, wherever the work pauses. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "dd/insert.h"
#include "hull/facets/facets.h"
#include "support.h"

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
    fmb_options o = {.size = sizeof o};
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
    cr_assert(several.cone.at->workers, "all was done by one thread");
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

/* ---- allocations that fail ------------------------------------------------------------------- */

typedef struct failing {
    atomic_long left; /* until one fails; all after it do not */
    atomic_long held; /* [bytes] */
} failing;

static void *resize_or_fail(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    failing *f = self;
    void *q = NULL;
    if (new_bytes == 0)
        free(p);
    else if (atomic_fetch_sub(&f->left, 1) == 1 || !(q = realloc(p, new_bytes)))
        return NULL;
    f->held += (long)new_bytes - (long)old_bytes;
    return q;
}

/* Whichever thread meets it, the status tells, and all is given back. */
Test(cone_threads, failing_allocations)
{
    static bench b;
    fmb_status st = FMB_ERR_MEMORY;
    for (long k = 1; st != FMB_OK; k += 1 + k / 3) {
        failing f = {.left = k};
        bool done;
        open_bench(&b, 3, true, false);
        b.mem.alloc = (fmb_alloc){resize_or_fail, &f};
        f.held = (long)b.mem.used;
        st = fmb_cone_run(&b.cone, 0, &done);
        cr_assert(st == FMB_ERR_MEMORY || (st == FMB_OK && done && f.left > 0));
        close_bench(&b);
        cr_assert_eq(f.held, 0);
    }
}

/* ---- facets ---------------------------------------------------------------------------------- */

enum { POINTS = 44 };

/* Points with coordinates of so many bits, (x, 1), and their facets. */
typedef struct hull {
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    int64_t word[POINTS][D];
    fmb_vec v[POINTS];
    fmb_facets f;
} hull;

static void open_hull(hull *h, size_t threads, int bits, size_t most_bytes)
{
    fmb_options o = {.size = sizeof o};
    support_rng g = {(uint64_t)bits};
    int least = -(1 << (bits - 1));
    *h = (hull){0};
    o.threads = threads;
    o.max_bytes = most_bytes;
    fmb_mem_init(&h->mem, NULL, 0);
    fmb_run_begin(&h->run, &h->mem, &o, &h->cancel, (fmb_sink){0}, "test");
    for (int i = 0; i < POINTS; i++) {
        for (int k = 0; k + 1 < D; k++)
            h->word[i][k] = support_between(&g, least, -least);
        h->word[i][D - 1] = 1;
        h->v[i] = (fmb_vec){.s = h->word[i]};
        fmb_vec_measure(&h->v[i], D);
    }
}

static fmb_status find_all_facets(hull *h)
{
    fmb_status st = fmb_facets_init(&h->f, &h->run, D);
    if (st == FMB_OK)
        st = fmb_facets_add_all(&h->f, h->v, POINTS, D - 1);
    return st == FMB_OK ? fmb_facets_need_all_normals(&h->f) : st;
}

static void close_hull(hull *h)
{
    fmb_facets_clear(&h->f);
    cr_assert_eq(h->mem.used, 0);
}

/* 0 on the generators of the facet, positive on all others. */
static void expect_normal(const fmb_facets *f, const fmb_facet *a)
{
    mpz_t sum, x, y;
    mpz_inits(sum, x, y, NULL);
    for (size_t i = 0; i < f->generators; i++) {
        mpz_set_ui(sum, 0);
        for (size_t k = 0; k < D; k++) {
            fmb_vec_get(&a->normal, k, x);
            fmb_vec_get(&f->generator[i], k, y);
            mpz_addmul(sum, x, y);
        }
        cr_assert_eq(mpz_sgn(sum), fmb_facet_holds(a, i) ? 0 : 1);
    }
    mpz_clears(sum, x, y, NULL);
}

/* 20 bits: minors fit into 126; 30 bits: they do not. */
static void check_normals(size_t threads, int bits)
{
    static hull one, several;
    open_hull(&one, 1, bits, 0);
    open_hull(&several, threads, bits, 0);
    cr_assert_eq(find_all_facets(&one), FMB_OK);
    cr_assert_eq(find_all_facets(&several), FMB_OK);
    cr_assert_eq(one.f.slots, several.f.slots);
    cr_assert_gt(one.f.alive, 500);
    for (size_t i = 0; i < one.f.slots; i++) {
        const fmb_facet *a = &one.f.facet[i], *b = &several.f.facet[i];
        cr_assert_eq(a->alive, b->alive);
        if (!a->alive)
            continue;
        expect_normal(&one.f, a);
        cr_assert(fmb_vec_equal(&a->normal, &b->normal, D));
        cr_assert_eq(fmb_vec_is_wide(&a->normal), fmb_vec_is_wide(&b->normal));
    }
    close_hull(&several);
    close_hull(&one);
}

Test(facet_threads, short_numbers)
{
    check_normals(2, 20);
    check_normals(7, 20);
}

Test(facet_threads, long_numbers)
{
    check_normals(2, 30);
    check_normals(3, 30);
}

Test(facet_threads, failing_allocations)
{
    static hull h;
    fmb_status st = FMB_ERR_MEMORY;
    for (long k = 1; st != FMB_OK; k += 1 + k / 3) {
        failing f = {.left = k};
        open_hull(&h, 3, 30, 0);
        h.mem.alloc = (fmb_alloc){resize_or_fail, &f};
        st = find_all_facets(&h);
        cr_assert(st == FMB_ERR_MEMORY || (st == FMB_OK && f.left > 0));
        close_hull(&h);
        cr_assert_eq(f.held, 0);
    }
}

/* Facets are limited as rows are. */
Test(facet_threads, few_rows)
{
    static hull h;
    open_hull(&h, 1, 20, 0);
    h.run.max_rows = 300;
    cr_assert_eq(find_all_facets(&h), FMB_LIMIT);
    cr_assert_eq(h.run.stop, FMB_STOP_ROWS);
    close_hull(&h);
}

Test(facet_threads, little_memory)
{
    static hull h;
    size_t limits = 0;
    for (size_t bytes = 1 << 18; bytes < 1 << 23; bytes += bytes / 2) {
        open_hull(&h, 3, 30, bytes);
        fmb_status st = find_all_facets(&h);
        cr_assert(st == FMB_OK || st == FMB_LIMIT);
        limits += st == FMB_LIMIT;
        close_hull(&h);
    }
    cr_assert_gt(limits, 0);
}
