/* edges.c: edges of simple rays, against tests of all pairs: corners of cubes, most of them with
 * rays between that are not simple. */
#include <criterion/criterion.h>

#include <string.h>

#include "dd/edges.h"
#include "support.h"

enum { MOST_RAYS = 600, WORDS = 3 };

static uint64_t support[MOST_RAYS][WORDS];

static void put_bit(size_t ray, size_t bit)
{
    support[ray][bit / 64] |= (uint64_t)1 << (bit % 64);
}

static bool has_bit(size_t ray, size_t bit)
{
    return support[ray][bit / 64] >> (bit % 64) & 1;
}

/* Corners of the cube of n dimensions near one of them, each once; bit 2 k + s: positive in row s
 * of coordinate k. */
static size_t make_corners(support_rng *g, size_t n, size_t rays)
{
    size_t made = 0;
    memset(support, 0, sizeof support);
    while (made < rays) {
        memset(support[made], 0, sizeof support[made]);
        for (size_t k = 0; k < n; k++)
            put_bit(made, 2 * k + (support_chance(g, 12) ? 1 : 0));
        bool again = false;
        for (size_t i = 0; i < made; i++)
            again |= memcmp(support[i], support[made], sizeof support[0]) == 0;
        made += !again;
    }
    return made;
}

/* Coordinates in which two corners differ. */
static size_t distance_of_corners(size_t a, size_t b, size_t n)
{
    size_t d = 0;
    for (size_t k = 0; k < n; k++)
        d += has_bit(a, 2 * k) != has_bit(b, 2 * k);
    return d;
}

Test(edges, neighbours_of_corners)
{
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel = 0;
    fmb_options o = {.size = sizeof o};
    fmb_ray_edges e = {0};
    size_t met = 0;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    for (uint64_t seed = 0; seed < 60; seed++) {
        support_rng g = {seed};
        size_t n = (size_t)support_between(&g, 10, 90), rays = 400;
        uint32_t list[MOST_RAYS];
        make_corners(&g, n, rays);
        for (size_t i = 0; i < rays; i++) {
            list[i] = (uint32_t)i;
            if (i % 7 == 0) /* zero in both rows of the last coordinate: not simple */
                support[i][(2 * n - 1) / 64] &= ~((uint64_t)3 << ((2 * n - 2) % 64));
        }
        fmb_edge_sides of = {support[0], WORDS, 2 * n, n + 1, list, list + 150, 150, rays - 150};
        cr_assert_eq(fmb_ray_edges_find(&e, &of, &run), FMB_OK);
        cr_assert_eq(e.degree, n);
        for (size_t i = 0; i < of.smalls; i++) {
            size_t ends = 0, truth = 0;
            cr_assert_eq(fmb_is_simple(&of, list[i]), i % 7 != 0);
            for (size_t k = 0; i % 7 != 0 && k < n; k++) {
                uint32_t end = e.edge[i * n + k].end;
                cr_assert(end == FMB_NO_RAY || distance_of_corners(i, end, n) == 1);
                ends += end != FMB_NO_RAY;
            }
            for (size_t j = of.smalls; i % 7 != 0 && j < rays; j++)
                truth += j % 7 != 0 && distance_of_corners(i, j, n) == 1;
            cr_assert_eq(ends, truth, "seed %lu, ray %zu", (unsigned long)seed, i);
            met += ends;
        }
    }
    cr_expect_gt(met, 1000);
    fmb_ray_edges_clear(&e, &mem);
    cr_assert_eq(mem.used, 0);
}
