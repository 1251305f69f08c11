/* section.c: rays of cones by support queries of a section, against double description: cones with
 * and without lines, of any rank, with an implied equality, and the cone {0}. */
#include <criterion/criterion.h>

#include "fault/hook.h"
#include "hull/section/section.h"
#include "support/dense.h"
#include "support/must.h"
#include "support/support.h"

enum { MOST_D = 7, MOST_ROWS = 60 };

typedef struct cone_rows {
    size_t d, m;
    int64_t word[MOST_ROWS][MOST_D];
    fmb_vec v[MOST_ROWS];
} cone_rows;

/* Near a form that is positive, so that there are rays; `rank` columns, then sums of these. */
static void draw_rows(support_rng *g, cone_rows *c, size_t rank, int64_t most, int64_t lift)
{
    for (size_t i = 0; i < c->m; i++) {
        for (size_t k = 0; k < c->d; k++)
            c->word[i][k] = k < rank ? (int64_t)support_between(g, 0, 2000) - 1000
                                     : c->word[i][0] + c->word[i][k - 1];
        for (size_t k = 0; k < rank; k++)
            c->word[i][k] = c->word[i][k] * most / 1000;
        c->word[i][0] += lift;
        for (size_t k = rank; k < c->d; k++)
            c->word[i][k] = c->word[i][0] + c->word[i][k - 1];
    }
}

static void measure_rows(cone_rows *c)
{
    for (size_t i = 0; i < c->m; i++) {
        c->v[i] = (fmb_vec){.s = c->word[i]};
        fmb_vec_measure(&c->v[i], c->d);
    }
}

static fmb_run begin_run(fmb_mem *mem, const fmb_alloc *alloc, const atomic_int *cancel)
{
    fmb_options o = {.size = sizeof o};
    fmb_run run;
    fmb_mem_init(mem, alloc, 0);
    fmb_run_begin(&run, mem, &o, cancel, (fmb_sink){0}, "test");
    return run;
}

static fmb_status find_by_section(const cone_rows *c, fmb_run *run, uint64_t pairs,
                                  fmb_image *image)
{
    fmb_section s;
    bool done = false;
    fmb_status st = fmb_section_open(&s, run, c->v, c->m, c->d);
    while (st == FMB_OK && !done)
        st = fmb_section_ask(&s, 0, pairs, &done);
    if (st == FMB_OK)
        st = fmb_section_take_rays(&s, image);
    fmb_section_close(&s);
    return st;
}

static void find_by_rows(const cone_rows *c, fmb_run *run, fmb_image *image)
{
    fmb_cone cone;
    fmb_cone_row row[MOST_ROWS];
    bool done;
    for (size_t i = 0; i < c->m; i++)
        row[i] = (fmb_cone_row){.v = &c->v[i]};
    fmb_cone_problem of = {.d = c->d, .m = c->m, .row = row};
    must(fmb_cone_init(&cone, run, &of));
    must(fmb_cone_run(&cone, 0, &done));
    must(fmb_image_init(image, run, &cone, cone.coords, false));
    fmb_cone_clear(&cone);
}

/* Where there are lines, a ray is not told but for these: then how many there are, and where. */
static void check_same_rays(const cone_rows *c, fmb_image *a, const fmb_image *b, uint64_t seed)
{
    cr_assert_eq(a->rays, b->rays, "seed %lu: %zu rays, not %zu", (unsigned long)seed, a->rays,
                 b->rays);
    cr_assert_eq(a->lines, b->lines);
    for (size_t i = 0; i < a->rays; i++) {
        for (size_t k = 0; k < c->m; k++)
            cr_assert_geq(fmb_image_value_sign(a, &c->v[k], &a->ray[i]), 0);
        if (a->lines == 0)
            cr_assert(fmb_vec_equal(&a->ray[i], &b->ray[i], c->d), "seed %lu", (unsigned long)seed);
    }
    for (size_t i = 0; i < a->lines; i++)
        for (size_t k = 0; k < c->m; k++)
            cr_assert_eq(fmb_image_value_sign(a, &c->v[k], &a->line[i]), 0);
}

static size_t compare_ways(cone_rows *c, uint64_t seed, uint64_t pairs)
{
    atomic_int cancel = 0;
    fmb_mem mem;
    fmb_run run = begin_run(&mem, NULL, &cancel);
    fmb_image a = {0}, b = {0};
    measure_rows(c);
    must(find_by_section(c, &run, pairs, &a));
    find_by_rows(c, &run, &b);
    check_same_rays(c, &a, &b, seed);
    size_t rays = a.rays;
    fmb_image_clear(&a);
    fmb_image_clear(&b);
    cr_assert_eq(mem.used, 0);
    return rays;
}

Test(section, random_cones)
{
    static const int64_t MOST[] = {2, 9, 1000, (int64_t)1 << 40};
    cone_rows c;
    size_t rays = 0;
    for (uint64_t seed = 0; seed < 300; seed++) {
        support_rng g = {seed};
        c.d = (size_t)support_between(&g, 1, 6);
        c.m = (size_t)support_between(&g, 1, seed % 3 ? 12 : 40);
        size_t rank = seed % 4 == 0 ? (c.d + 1) / 2 : c.d;
        int64_t most = MOST[seed % 4];
        draw_rows(&g, &c, rank, most, seed % 5 ? most : 0);
        rays += compare_ways(&c, seed, seed % 2);
    }
    cr_expect_gt(rays, 1500);
}

Test(section, equalities_that_rows_imply)
{
    cone_rows c = {.d = 4, .m = 12};
    for (uint64_t seed = 0; seed < 20; seed++) {
        support_rng g = {seed};
        draw_rows(&g, &c, 4, 9, 9);
        for (size_t k = 0; k < 4; k++)
            c.word[11][k] = -c.word[3][k];
        compare_ways(&c, seed, 0);
    }
}

Test(section, nothing_but_zero)
{
    cone_rows c = {.d = 3, .m = 4, .word = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}}};
    cr_expect_eq(compare_ways(&c, 0, 0), 0);
    c.word[3][0] = 0; /* and one ray */
    cr_expect_eq(compare_ways(&c, 0, 0), 1);
    c.m = 0;
    cr_expect_eq(compare_ways(&c, 0, 0), 0);
    /* two equalities beside a line: the mean of the rows is 0, and no form of theirs */
    cone_rows flat = {.d = 3, .m = 4, .word = {{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    cr_expect_eq(compare_ways(&flat, 0, 0), 0);
}

/* A cone without lines, and all that was found of it. */
typedef struct known_section {
    cone_rows c;
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_section s;
    fmb_image image;
} known_section;

/* False: it has a line, or no point for each ray. Close it in any case. */
static bool open_known_section(known_section *k, uint64_t seed)
{
    support_rng g = {seed};
    bool done = false;
    *k = (known_section){.c = {.d = 3, .m = 7}};
    k->run = begin_run(&k->mem, NULL, &k->cancel);
    draw_rows(&g, &k->c, 3, 9, 9);
    measure_rows(&k->c);
    must(fmb_section_open(&k->s, &k->run, k->c.v, k->c.m, k->c.d));
    while (!done)
        must(fmb_section_ask(&k->s, 0, 0, &done));
    must(fmb_section_take_rays(&k->s, &k->image));
    return k->s.begun && k->s.rank == 3 && k->s.support.hull.generators == k->image.rays;
}

static void close_known_section(known_section *k)
{
    fmb_image_clear(&k->image);
    fmb_section_close(&k->s);
    cr_assert_eq(k->mem.used, 0);
}

/* The first point becomes that on the line through z; false: there is none. */
static bool move_first_point(known_section *k, const int64_t *z)
{
    fmb_section *s = &k->s;
    fmb_vec *v = &s->support.hull.generator[0];
    int64_t t = 0;
    for (size_t j = 0; j < 3; j++)
        t += (int64_t)mpz_get_si(s->w.z[j]) * z[j];
    v->s[0] = t < 0 ? -t : t;
    for (size_t j = 0; j < 2; j++)
        v->s[j + 1] = t < 0 ? -z[s->column[j]] : z[s->column[j]];
    fmb_vec_measure(v, 3);
    return t != 0;
}

/* Is that point taken for a ray? */
static bool is_moved_point_taken(known_section *k)
{
    fmb_image image = {0};
    must(fmb_section_take_rays(&k->s, &image));
    size_t rays = image.rays;
    fmb_image_clear(&image);
    return rays == k->image.rays;
}

/* The sum of two rays is none, even on a facet. */
static int check_sums_of_rays(known_section *k)
{
    int moved = 0;
    for (size_t i = 1; i < k->image.rays; i++) {
        const int64_t *a = k->image.ray[0].s, *b = k->image.ray[i].s;
        if (!move_first_point(k, (const int64_t[]){a[0] + b[0], a[1] + b[1], a[2] + b[2]}))
            continue;
        cr_assert(!is_moved_point_taken(k));
        moved++;
    }
    return moved;
}

/* Where two rows are 0 is a ray only if no other is negative. */
static int check_meets_of_rows(known_section *k)
{
    int moved = 0;
    for (size_t code = 0; code < k->c.m * k->c.m; code++) {
        const int64_t *a = k->c.word[code / k->c.m], *b = k->c.word[code % k->c.m];
        const int64_t z[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                              a[0] * b[1] - a[1] * b[0]};
        bool below = false, above = false;
        for (size_t i = 0; i < k->c.m; i++) {
            const int64_t *r = k->c.word[i];
            int64_t value = r[0] * z[0] + r[1] * z[1] + r[2] * z[2];
            below = below || value < 0;
            above = above || value > 0;
        }
        if (!below || !above || !move_first_point(k, z))
            continue;
        cr_assert(!is_moved_point_taken(k));
        moved++;
    }
    return moved;
}

Test(section, points_that_are_no_rays_are_refused)
{
    int sums = 0, meets = 0;
    for (uint64_t seed = 0; seed < 40; seed++) {
        known_section k;
        if (open_known_section(&k, seed)) {
            sums += check_sums_of_rays(&k);
            meets += check_meets_of_rows(&k);
        }
        close_known_section(&k);
    }
    cr_expect(sums > 50 && meets > 200, "%d, %d", sums, meets);
}

Test(section, every_request_may_fail)
{
    cone_rows c = {.d = 5, .m = 20};
    support_rng g = {7};
    atomic_int cancel = 0;
    draw_rows(&g, &c, 4, (int64_t)1 << 40, (int64_t)1 << 40);
    measure_rows(&c);
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st == FMB_ERR_MEMORY; k += 1 + k / 64) {
        hook h = {0};
        fmb_alloc alloc = hook_alloc(&h);
        fmb_mem mem;
        fmb_run run = begin_run(&mem, &alloc, &cancel);
        fmb_image a = {0};
        hook_arm(&h, k, k % 2 == 0);
        st = find_by_section(&c, &run, 0, &a);
        hook_calm(&h);
        fmb_image_clear(&a);
        cr_assert_eq(h.live, 0, "request %zu: %zu bytes leak", k, h.live);
        cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY);
    }
}
