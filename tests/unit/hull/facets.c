/* facets.c: facets while vectors are added, against all hyperplanes through enough of the vectors,
 * and polytopes with known facets. */
#include <criterion/criterion.h>

#include <stdlib.h>
#include <string.h>

#include "cloud.h"
#include "hull/facets/facets.h"
#include "support/support.h"

/* ---- what is tested -------------------------------------------------------------------------- */

typedef struct bench {
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_facets f;
    int d;
    mpz_t z[MOST_D];
} bench;

static void open_bench(bench *b, int d)
{
    fmb_options o = {.size = sizeof o};
    *b = (bench){.d = d};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    for (int j = 0; j < MOST_D; j++)
        mpz_init(b->z[j]);
    cr_assert_eq(fmb_facets_init(&b->f, &b->run, (size_t)d), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_facets_clear(&b->f);
    for (int j = 0; j < MOST_D; j++)
        mpz_clear(b->z[j]);
    cr_assert_eq(b->mem.used, 0);
}

/* out[d] = v, with every entry j > 0 made larger by 2^bits times the one before: the same cone,
 * sheared. If bits < 0, entry j becomes 2^(-bits j) times itself: the same cone, stretched. */
static void shear(mpz_t *out, int d, const int64_t *v, int bits)
{
    for (int j = 0; j < d; j++) {
        mpz_set_si(out[j], v[j]);
        if (bits < 0)
            mpz_mul_2exp(out[j], out[j], (mp_bitcnt_t)(-bits * j));
        if (bits > 0 && j > 0) {
            mpz_t t;
            mpz_init(t);
            mpz_mul_2exp(t, out[j - 1], (mp_bitcnt_t)bits);
            mpz_add(out[j], out[j], t);
            mpz_clear(t);
        }
    }
}

/* Wherever the search begins. */
static bool add(bench *b, const int64_t *v, int bits)
{
    bool grown;
    shear(b->z, b->d, v, bits);
    cr_assert_eq(fmb_facets_add_near(&b->f, 7 * b->f.generators, b->z, &grown), FMB_OK);
    return grown;
}

static int sign_on(bench *b, const fmb_vec *normal, const int64_t *v, int bits)
{
    mpz_t sum, t;
    mpz_inits(sum, t, NULL);
    shear(b->z, b->d, v, bits);
    for (int j = 0; j < b->d; j++) {
        fmb_vec_get(normal, (size_t)j, t);
        mpz_addmul(sum, b->z[j], t);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(sum, t, NULL);
    return sign;
}

/* What of the cloud is on a facet; and no vector is behind it. */
static uint32_t set_on(bench *b, const fmb_facet *a, const cloud *c, int bits)
{
    uint32_t on = 0;
    for (int i = 0; i < c->size; i++) {
        int sign = sign_on(b, &a->normal, c->v[i], bits);
        cr_assert_geq(sign, 0);
        on |= (uint32_t)(sign == 0) << i;
    }
    return on;
}

static void check_neighbours(const bench *b, const cloud *c, const uint32_t *on, int rank)
{
    const fmb_facets *f = &b->f;
    for (size_t i = 0; i < f->slots; i++) {
        const fmb_facet *a = &f->facet[i];
        size_t ridges = 0;
        for (size_t k = 0; a->alive && k < f->slots; k++)
            ridges += k != i && f->facet[k].alive && cloud_rank(c, on[i] & on[k]) == rank - 2;
        if (a->alive)
            cr_assert_eq(a->nexts, ridges, "%zu neighbours of %zu", a->nexts, ridges);
        for (size_t k = 0; a->alive && k < a->nexts; k++) {
            cr_assert(f->facet[a->next[k]].alive);
            cr_assert_eq(cloud_rank(c, on[i] & on[a->next[k]]), rank - 2);
        }
    }
}

/* One by one; generator[] gets the vectors that became generators. */
static int add_one_by_one(bench *b, const cloud *c, int bits, int *generator)
{
    int generators = 0;
    for (int i = 0; i < c->size; i++)
        if (add(b, c->v[i], bits))
            generator[generators++] = i;
    return generators;
}

static int find_vector(const fmb_vec *v, int size, const fmb_vec *wanted, size_t d)
{
    int i = 0;
    while (i < size && !fmb_vec_equal(&v[i], wanted, d))
        i++;
    return i;
}

/* All at once. */
static int add_all(bench *b, const cloud *c, int bits, int *generator)
{
    fmb_vec v[MOST] = {{0}};
    size_t d = (size_t)c->d;
    for (int i = 0; i < c->size; i++) {
        v[i].s = calloc(d, sizeof *v[i].s);
        shear(b->z, b->d, c->v[i], bits);
        cr_assert_eq(fmb_vec_set_z(&v[i], d, b->z, &b->mem), FMB_OK);
        cr_assert_eq(fmb_vec_reduce(&v[i], d, &b->f.num), FMB_OK);
    }
    cr_assert_eq(fmb_facets_add_all(&b->f, v, (size_t)c->size, 0), FMB_OK);
    for (size_t i = 0; i < b->f.generators; i++)
        generator[i] = find_vector(v, c->size, &b->f.generator[i], d);
    for (int i = 0; i < c->size; i++) {
        fmb_vec_clear(&v[i], d, &b->mem);
        free(v[i].s);
    }
    return (int)b->f.generators;
}

static void check_cloud_with(const cloud *c, int bits,
                             int (*fill)(bench *, const cloud *, int, int *))
{
    bench b;
    static uint32_t truth[1 << 16];
    size_t size = cloud_facets(c, truth), met = 0;
    int generator[MOST];
    open_bench(&b, c->d);
    int generators = fill(&b, c, bits, generator);
    int rank = cloud_rank(c, (1u << c->size) - 1);
    cr_assert_eq(b.f.rank, (size_t)rank);
    cr_assert_eq(b.f.generators, (size_t)generators);
    cr_assert_eq(b.f.alive, size, "%zu facets of %zu", b.f.alive, size);
    for (int e = 0; e < c->d - rank; e++)
        for (int i = 0; i < c->size; i++)
            cr_assert_eq(sign_on(&b, &b.f.equation[e], c->v[i], bits), 0);
    uint32_t *on = calloc(b.f.slots + 1, sizeof *on);
    for (size_t a = 0; a < b.f.slots; a++) {
        const fmb_facet *t = &b.f.facet[a];
        if (!t->alive)
            continue;
        cr_assert_eq(fmb_facets_need_normal(&b.f, a), FMB_OK);
        on[a] = set_on(&b, t, c, bits);
        met += cloud_put_set(truth, size, on[a]) == size;
        for (int i = 0; i < generators; i++)
            cr_assert_eq(fmb_facet_holds(t, (size_t)i), on[a] >> generator[i] & 1);
        cr_assert(!t->valued && fmb_vec_sgn(&t->normal, (size_t)c->d) == 0);
    }
    cr_assert_eq(met, size);
    check_neighbours(&b, c, on, rank);
    free(on);
    close_bench(&b);
}

static void check_cloud(const cloud *c, int bits)
{
    check_cloud_with(c, bits, add_one_by_one);
    check_cloud_with(c, bits, add_all);
}

/* ---- clouds ---------------------------------------------------------------------------------- */

/* Points, mostly, with numbers up to `most`; the last `flat` columns depend on the others. */
static cloud random_cloud(support_rng *g)
{
    cloud c = {support_between(g, 1, 5), support_between(g, 1, 11), {{0}}};
    int most = support_between(g, 1, 5), rays = support_chance(g, 50) ? 0 : 40;
    int flat = support_chance(g, 30) ? support_between(g, 0, c.d - 1) : 0;
    for (int i = 0; i < c.size; i++) {
        bool any = false;
        c.v[i][0] = !support_chance(g, rays);
        for (int j = 1; j < c.d; j++)
            c.v[i][j] =
                j < c.d - flat ? support_between(g, -most, most) : c.v[i][j - 1] - c.v[i][0];
        for (int j = 0; j < c.d; j++)
            any |= c.v[i][j] != 0;
        c.v[i][0] = any ? c.v[i][0] : 1;
    }
    return c;
}

Test(facets, random_clouds)
{
    for (uint64_t seed = 0; seed < 3000; seed++) {
        support_rng g = {seed};
        cloud c = random_cloud(&g);
        check_cloud(&c, seed % 5 == 0 ? 40 : seed % 7 == 0 ? 100 : 0);
    }
}

/* Numbers so long that normals are kept in doubles, in more dimensions longer than 64 bits. */
Test(facets, long_numbers)
{
    for (uint64_t seed = 0; seed < 400; seed++) {
        support_rng g = {seed};
        cloud c = {support_between(&g, 3, 5), support_between(&g, 6, 12), {{0}}};
        int most = c.d == 5 ? 200 : 10000; /* the truth is found in int64 */
        for (int i = 0; i < c.size; i++) {
            c.v[i][0] = 1;
            for (int j = 1; j < c.d; j++)
                c.v[i][j] = support_between(&g, -most, most);
        }
        for (int j = 0; j < c.d; j++) /* four in a plane */
            c.v[5][j] = c.v[0][j] + c.v[1][j] - c.v[2][j];
        check_cloud(&c, seed % 3 == 0 ? 20 : 0);
    }
}

/* Entries that spread over more than doubles do, of points near and far: what underflows counts. */
Test(facets, wide_spreads)
{
    static const int bits[] = {-170, -260, -400, -530, -550, -1000, -1020, -1070, -3000};
    for (uint64_t seed = 0; seed < 1800; seed++) {
        support_rng g = {seed};
        cloud c = random_cloud(&g);
        check_cloud(&c, bits[seed % (sizeof bits / sizeof *bits)]);
    }
}

enum { LONG_POINTS = 40, LONG_D = 4 };

/* A point (x, y, z) / 3^power times 2^bits, but for a little: its numbers stay that long in lowest
 * terms. */
static void draw_long_point(bench *b, support_rng *g, int power, int bits, fmb_vec *v)
{
    mpz_ui_pow_ui(b->z[0], 3, (unsigned long)power);
    for (int j = 1; j < LONG_D; j++) {
        mpz_set_si(b->z[j], support_between(g, -30000, 30000));
        mpz_mul_2exp(b->z[j], b->z[j], (mp_bitcnt_t)bits);
        mpz_add_ui(b->z[j], b->z[j], 1);
    }
    *v = (fmb_vec){.s = calloc(LONG_D, sizeof *v->s)};
    cr_assert_eq(fmb_vec_set_z(v, LONG_D, b->z, &b->mem), FMB_OK);
}

/* Of the hull of points drawn from that seed, all at once: normals found in integers. */
static size_t count_known_normals(uint64_t seed, int power, int bits)
{
    support_rng g = {seed};
    bench b;
    fmb_vec v[LONG_POINTS];
    size_t known = 0;
    open_bench(&b, LONG_D);
    for (int i = 0; i < LONG_POINTS; i++)
        draw_long_point(&b, &g, power, bits, &v[i]);
    cr_assert_eq(fmb_facets_add_all(&b.f, v, LONG_POINTS, 0), FMB_OK);
    for (size_t a = 0; a < b.f.slots; a++)
        known += b.f.facet[a].alive && b.f.facet[a].known;
    cr_expect_gt(b.f.alive, 20);
    for (int i = 0; i < LONG_POINTS; i++) {
        fmb_vec_clear(&v[i], LONG_D, &b.mem);
        free(v[i].s);
    }
    close_bench(&b);
    return known;
}

/* Numbers beyond doubles are told in doubles like shorter ones. */
Test(facets, numbers_beyond_doubles)
{
    for (uint64_t seed = 0; seed < 20; seed++) {
        size_t known = count_known_normals(seed, 60, 100);
        cr_expect_eq(count_known_normals(seed, 900, 1430), known, "seed %d", (int)seed);
    }
}

/* Vectors in all directions: cones that contain lines, or all there is. */
Test(facets, lines)
{
    for (uint64_t seed = 0; seed < 1000; seed++) {
        support_rng g = {seed};
        cloud c = {support_between(&g, 1, 4), support_between(&g, 1, 9), {{0}}};
        for (int i = 0; i < c.size; i++) {
            for (int j = 0; j < c.d; j++)
                c.v[i][j] = support_between(&g, -1, 1);
            c.v[i][i % c.d] += c.v[i][i % c.d] == 0;
        }
        check_cloud(&c, 0);
    }
}

static size_t facets_of(bench *b)
{
    size_t alive = b->f.alive;
    close_bench(b);
    return alive;
}

Test(facets, cubes)
{
    for (int n = 1; n <= 5; n++) {
        bench b;
        open_bench(&b, n + 1);
        for (int i = 0; i < 1 << n; i++) {
            int64_t v[MOST_D] = {1};
            for (int j = 0; j < n; j++)
                v[j + 1] = i >> j & 1 ? 1 : -1;
            cr_assert(add(&b, v, 0));
        }
        cr_assert_eq(facets_of(&b), (size_t)(2 * n));
    }
}

Test(facets, cross_polytopes)
{
    for (int n = 1; n <= 5; n++) {
        bench b;
        open_bench(&b, n + 1);
        for (int i = 0; i < 2 * n; i++) {
            int64_t v[MOST_D] = {1};
            v[1 + i / 2] = i % 2 ? 1 : -1;
            cr_assert(add(&b, v, 0));
        }
        cr_assert_eq(facets_of(&b), (size_t)1 << n);
    }
}

/* On the curve (t, t^2, ..., t^n): n / (n - k) choose(n - k, k) facets for n = 2k dimensions of v
 * points, here v (v - 3) / 2 in four. */
Test(facets, cyclic)
{
    bench b;
    open_bench(&b, 5);
    for (int64_t t = 1; t <= 80; t++) {
        const int64_t v[MOST_D] = {1, t, t * t, t * t * t, t * t * t * t};
        cr_assert(add(&b, v, 0));
    }
    cr_assert_eq(facets_of(&b), (size_t)(80 * 77 / 2));
}

/* A grid in a triangle has three facets, in whatever order its points come; all others are on
 * them or inside. */
Test(facets, grids)
{
    for (uint64_t seed = 0; seed < 50; seed++) {
        support_rng g = {seed};
        bench b;
        int64_t v[66][MOST_D];
        int size = 0;
        for (int x = 0; x <= 10; x++)
            for (int y = 0; x + y <= 10; y++) {
                const int64_t t[MOST_D] = {1, x, y};
                memcpy(v[size++], t, sizeof t);
            }
        open_bench(&b, 3);
        for (int i = 0; i < size; i++) {
            int k = support_between(&g, i, size - 1);
            int64_t t[MOST_D];
            memcpy(t, v[k], sizeof t);
            memcpy(v[k], v[i], sizeof t);
            add(&b, t, 0);
        }
        cr_assert_eq(facets_of(&b), 3);
    }
}

/* Points on a sphere in general position: 2v - 4 triangles. */
Test(facets, sphere)
{
    support_rng g = {7};
    bench b;
    open_bench(&b, 4);
    for (int i = 0; i < 300; i++) {
        int64_t p = support_between(&g, -999, 999), q = support_between(&g, -999, 999);
        int64_t n = 1000003 + p * p + q * q; /* stereographic: all on one sphere */
        const int64_t v[MOST_D] = {n, 2 * p * 1000, 2 * q * 1000, n - 2 * 1000003};
        add(&b, v, 0);
    }
    size_t v = b.f.generators;
    cr_assert_gt(v, 250);
    size_t edges = 0;
    for (size_t a = 0; a < b.f.slots; a++)
        edges += b.f.facet[a].alive ? b.f.facet[a].nexts : 0;
    cr_assert_eq(v + b.f.alive, edges / 2 + 2);
    close_bench(&b);
}
