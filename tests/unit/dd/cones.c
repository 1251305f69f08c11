/* cones.c: rays and lines of small cones, slacks carried along or by dot products, at once or with
 * pauses, against all sets of rows that may define a ray; and cones with known rays. */
#include <criterion/criterion.h>

#include <stdlib.h>
#include <string.h>

#include "dd/cone.h"
#include "support.h"

enum { MOST_D = 12, MOST_ROWS = 30, MOST_RAYS = 4096 };

/* Rows as plain numbers. */
typedef struct plain {
    size_t d, m;
    int64_t row[MOST_ROWS][MOST_D];
    bool equality[MOST_ROWS];
} plain;

typedef struct ray_list {
    size_t size, lines;
    int64_t ray[MOST_RAYS][MOST_D];
} ray_list;

static ray_list found, other, truth;

/* ---- the library ----------------------------------------------------------------------------- */

static int compare_rays(const void *a, const void *b)
{
    const int64_t *x = a, *y = b;
    for (size_t k = 0; k < MOST_D; k++)
        if (x[k] != y[k])
            return x[k] < y[k] ? -1 : 1;
    return 0;
}

static void make_primitive(int64_t *x, size_t d)
{
    int64_t g = 0;
    for (size_t k = 0; k < d; k++) {
        int64_t a = llabs(x[k]), b = g;
        while (b != 0) {
            int64_t t = a % b;
            a = b;
            b = t;
        }
        g = a;
    }
    for (size_t k = 0; g > 1 && k < d; k++)
        x[k] /= g;
}

static void check_supports(const plain *p, const fmb_cone *c, size_t i, const int64_t *x)
{
    for (size_t b = 0; b < c->bits; b++) {
        int64_t value = 0;
        for (size_t k = 0; k < p->d; k++)
            value += p->row[c->row_of_bit[b]][k] * x[k];
        cr_assert_eq(value > 0, fmb_cone_is_positive(c, i, b), "a support is wrong");
    }
}

/* The rays of p, primitive and sorted. pause: rays between two stops, 0: none; odd: sparse rows
 * first. */
static void list_rays(const plain *p, bool carried, uint64_t pause, bool wide, ray_list *out)
{
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel = 0;
    fmb_options o = {.size = sizeof o};
    fmb_vec v[MOST_ROWS];
    fmb_cone_row row[MOST_ROWS];
    size_t keep[MOST_D];
    int64_t words[MOST_ROWS][MOST_D];
    fmb_cone c;
    bool done = false;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    memcpy(words, p->row, sizeof words);
    for (size_t i = 0; i < p->m; i++) {
        v[i] = (fmb_vec){.s = words[i]};
        fmb_vec_measure(&v[i], p->d);
        row[i] = (fmb_cone_row){.v = &v[i], .equality = p->equality[i]};
    }
    for (size_t k = 0; k < p->d; k++)
        keep[k] = k;
    fmb_cone_problem of = {p->d, p->m, row, p->d, carried ? keep : NULL, wide, pause % 2};
    cr_assert_eq(fmb_cone_init(&c, &run, &of), FMB_OK);
    while (!done)
        cr_assert_eq(fmb_cone_run(&c, pause, &done), FMB_OK);
    memset(out, 0, sizeof *out);
    out->size = c.ray.size;
    out->lines = c.line.size;
    cr_assert_leq(out->size, MOST_RAYS);
    for (size_t i = 0; i < out->size; i++) {
        mpz_t z;
        mpz_init(z);
        for (size_t k = 0; k < p->d; k++) {
            fmb_vec_get(&c.ray.v[i], k, z);
            out->ray[i][k] = mpz_get_si(z);
        }
        mpz_clear(z);
        make_primitive(out->ray[i], p->d);
        check_supports(p, &c, i, out->ray[i]);
    }
    qsort(out->ray, out->size, sizeof *out->ray, compare_rays);
    fmb_cone_clear(&c);
    cr_assert_eq(mem.used, 0);
}

/* ---- the truth ------------------------------------------------------------------------------- */

/* The rank of these rows, and, if it is d - 1, the one direction in which all are 0. Fraction-free
 * elimination. */
static size_t find_kernel(const plain *p, unsigned rows, int64_t *x)
{
    int64_t t[MOST_ROWS][MOST_D];
    size_t m = 0, rank = 0, pivot[MOST_D], free_column = 0;
    for (size_t i = 0; i < p->m; i++)
        if (rows >> i & 1)
            memcpy(t[m++], p->row[i], sizeof t[0]);
    for (size_t k = 0; k < p->d; k++) {
        size_t r = rank;
        while (r < m && t[r][k] == 0)
            r++;
        if (r == m) {
            free_column = k;
            continue;
        }
        for (size_t j = 0; j < p->d; j++) {
            int64_t swap = t[r][j];
            t[r][j] = t[rank][j];
            t[rank][j] = swap;
        }
        for (size_t i = 0; i < m; i++) {
            int64_t a = t[rank][k], b = t[i][k];
            for (size_t j = 0; i != rank && b != 0 && j < p->d; j++)
                t[i][j] = a * t[i][j] - b * t[rank][j];
            make_primitive(t[i], p->d);
        }
        pivot[rank++] = k;
    }
    if (rank + 1 != p->d)
        return rank;
    int64_t scale = 1;
    for (size_t r = 0; r < rank; r++)
        scale *= t[r][pivot[r]];
    memset(x, 0, MOST_D * sizeof *x);
    x[free_column] = scale;
    for (size_t r = 0; r < rank; r++)
        x[pivot[r]] = -scale / t[r][pivot[r]] * t[r][free_column];
    make_primitive(x, p->d);
    return rank;
}

static bool is_in_cone(const plain *p, const int64_t *x)
{
    for (size_t i = 0; i < p->m; i++) {
        int64_t value = 0;
        for (size_t k = 0; k < p->d; k++)
            value += p->row[i][k] * x[k];
        if (value < 0 || (p->equality[i] && value != 0))
            return false;
    }
    return true;
}

/* Every set of rows with one direction in common. */
static void list_rays_by_subsets(const plain *p, ray_list *out)
{
    int64_t x[MOST_D];
    memset(out, 0, sizeof *out);
    out->lines = p->d - find_kernel(p, (1u << p->m) - 1, x);
    for (unsigned rows = 0; rows < 1u << p->m; rows++) {
        unsigned equalities = 0;
        for (size_t i = 0; i < p->m && i < MOST_ROWS; i++)
            equalities |= (unsigned)p->equality[i] << i;
        if ((rows & equalities) != equalities || find_kernel(p, rows, x) + 1 != p->d)
            continue;
        for (int sign = 0; sign < 2; sign++) {
            if (is_in_cone(p, x))
                memcpy(out->ray[out->size++], x, sizeof out->ray[0]);
            for (size_t k = 0; k < p->d; k++)
                x[k] = -x[k];
        }
    }
    qsort(out->ray, out->size, sizeof *out->ray, compare_rays);
    size_t left = 0;
    for (size_t i = 0; i < out->size; i++)
        if (i == 0 || compare_rays(out->ray[i], out->ray[left - 1]) != 0)
            memmove(out->ray[left++], out->ray[i], sizeof out->ray[0]);
    out->size = left;
}

static plain random_rows(support_rng *g)
{
    plain p = {.d = (size_t)support_between(g, 1, 5), .m = (size_t)support_between(g, 0, 10)};
    int size = support_between(g, 1, 4), equalities = support_between(g, 0, 60);
    for (size_t i = 0; i < p.m; i++) {
        p.equality[i] = (i == 0 || p.equality[i - 1]) && support_chance(g, equalities);
        for (size_t k = 0; k < p.d; k++)
            p.row[i][k] = support_between(g, -size, size);
    }
    return p;
}

static void expect_same_rays(const ray_list *a, const ray_list *b, uint64_t seed)
{
    cr_assert(a->size == b->size && a->lines == b->lines, "seed %lu: %zu and %zu rays",
              (unsigned long)seed, a->size, b->size);
    cr_assert(memcmp(a->ray, b->ray, a->size * sizeof *a->ray) == 0, "seed %lu",
              (unsigned long)seed);
}

Test(cones, small_ones_by_subsets)
{
    int pointed = 0;
    for (uint64_t seed = 0; seed < 1500; seed++) {
        support_rng g = {seed};
        plain p = random_rows(&g);
        list_rays_by_subsets(&p, &truth);
        list_rays(&p, true, 0, false, &found);
        cr_assert_eq(found.lines, truth.lines);
        list_rays(&p, true, 1, seed % 3 == 0, &other);
        cr_assert(found.size == other.size && found.lines == other.lines);
        if (truth.lines == 0)
            expect_same_rays(&found, &other, seed);
        list_rays(&p, false, seed % 2, false, &other);
        cr_assert(found.size == other.size && found.lines == other.lines);
        if (truth.lines > 0)
            continue;
        pointed++;
        expect_same_rays(&found, &truth, seed);
        expect_same_rays(&other, &truth, seed);
    }
    cr_expect_gt(pointed, 500);
}

/* ---- known numbers of rays ------------------------------------------------------------------- */

/* -t <= x_k <= t. */
static plain cube(size_t n)
{
    plain p = {.d = n + 1, .m = 2 * n};
    for (size_t i = 0; i < p.m; i++) {
        p.row[i][i / 2] = i % 2 ? 1 : -1;
        p.row[i][n] = 1;
    }
    return p;
}

Test(cones, a_cube_has_all_its_corners)
{
    for (size_t n = 1; n <= 10; n++) {
        plain p = cube(n);
        list_rays(&p, true, 0, false, &found);
        cr_expect(found.size == (size_t)1 << n && found.lines == 0);
    }
}

/* Points of the moment curve as rows: the facets of a cyclic polytope, whose number is known
 * (Gale's evenness condition; Ziegler 1995, Lectures on polytopes, theorem 0.7). */
Test(cones, a_cyclic_polytope_has_the_most_facets)
{
    static const size_t facets[][3] = {{2, 9, 9}, {3, 9, 14}, {4, 9, 27}, {5, 9, 30}, {4, 12, 54}};
    for (size_t i = 0; i < sizeof facets / sizeof *facets; i++) {
        plain p = {.d = facets[i][0] + 1, .m = facets[i][1]};
        for (size_t k = 0; k < p.m; k++)
            for (size_t j = 0; j < p.d; j++)
                p.row[k][j] = j == 0 ? 1 : p.row[k][j - 1] * ((int64_t)k - 4);
        list_rays(&p, false, 0, false, &found);
        cr_expect_eq(found.size, facets[i][2], "%zu facets", found.size);
        list_rays(&p, true, 7, false, &other);
        expect_same_rays(&found, &other, i);
    }
}
