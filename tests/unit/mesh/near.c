/* near.c: cells within a distance, and the distance of two meshes, against the exact distance of
 * each pair of cells. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>
#include <fmb/mesh.h>

#include "fault/hook.h"
#include "soup.h"

#ifndef SEED
#define SEED 20261
#endif

enum { NEAR_CELLS = 8, LENGTHS = 6 };

/* ---- truth ----------------------------------------------------------------------------------- */

typedef struct distances {
    size_t rows, columns;
    mpq_t *square; /* [rows][columns] */
} distances;

static fmb_frame frame_of(const fmb_mesh *m, size_t c, const double *speed, double number[12])
{
    int corners = fmb_mesh_corners(m);
    for (int k = 0; k < corners; k++)
        memcpy(number + 3 * k,
               fmb_mesh_points(m) + 3 * fmb_mesh_indices(m)[c * (size_t)corners + (size_t)k],
               3 * sizeof *number);
    return (fmb_frame){FMB_SIMPLEX_BY_CORNERS, 3, corners - 1, number, number + 3, speed};
}

static distances measure_all(const fmb_mesh *m, const fmb_mesh *n, const double *motion)
{
    distances d = {fmb_mesh_cells(m), fmb_mesh_cells(n), NULL};
    fmb_solver *v = NULL;
    must(fmb_solver_new(NULL, NULL, &v));
    cr_assert(d.square = malloc(d.rows * d.columns * sizeof *d.square));
    for (size_t i = 0; i < d.rows; i++)
        for (size_t j = 0; j < d.columns; j++) {
            double number[2][12];
            fmb_frame f[2] = {frame_of(m, i, NULL, number[0]), frame_of(n, j, motion, number[1])};
            fmb_proximity *p = NULL;
            mpq_init(d.square[i * d.columns + j]);
            must(fmb_distance(v, f, FMB_NORM_EUCLIDEAN, &p, NULL));
            fmb_proximity_measure_q(p, d.square[i * d.columns + j]);
            fmb_proximity_free(p);
        }
    fmb_solver_free(v);
    return d;
}

static void forget_distances(distances *d)
{
    for (size_t i = 0; i < d->rows * d->columns; i++)
        mpq_clear(d->square[i]);
    free(d->square);
}

/* ---- lengths --------------------------------------------------------------------------------- */

/* The root of a square, rounded down (more: up) to a multiple of 2^-digits. */
static void take_root_about(mpq_t x, unsigned long digits, bool more)
{
    mpq_mul_2exp(x, x, 2 * digits);
    mpz_t root, whole;
    mpz_inits(root, whole, NULL);
    mpz_cdiv_q(whole, mpq_numref(x), mpq_denref(x));
    if (!more)
        mpz_fdiv_q(whole, mpq_numref(x), mpq_denref(x));
    mpz_sqrt(root, whole);
    if (more && !mpz_perfect_square_p(whole))
        mpz_add_ui(root, root, 1);
    mpq_set_z(x, root);
    mpq_div_2exp(x, x, digits);
    mpz_clears(root, whole, NULL);
}

/* 0; about the distance of some pair, on either side of it and, if its root is rational, that; a
 * third of it. */
static void choose_length(support_rng *g, const distances *d, int which, mpq_t out)
{
    size_t i = (size_t)support_between(g, 0, (int)(d->rows * d->columns) - 1);
    mpq_set(out, d->square[i]);
    take_root_about(out, 1200, which % 2 != 0);
    if (which == 0)
        mpq_set_ui(out, 0, 1);
    if (which == 1) {
        mpz_mul_ui(mpq_denref(out), mpq_denref(out), 3);
        mpq_canonicalize(out);
    }
}

/* ---- answers --------------------------------------------------------------------------------- */

static void judge_hits(const distances *d, mpq_srcptr length, const fmb_mesh_answer *answer)
{
    size_t k = 0;
    mpq_t most;
    mpq_init(most);
    mpq_mul(most, length, length);
    for (size_t i = 0; i < d->rows; i++)
        for (size_t j = 0; j < d->columns; j++) {
            mpq_srcptr at = d->square[i * d->columns + j];
            bool here = k < answer->hits && answer->hit[k].a == i && answer->hit[k].b == j;
            cr_assert(here == (mpq_cmp(at, most) <= 0), "%zu %zu", i, j);
            cr_assert(!here || (answer->hit[k].how == FMB_MESH_APART) == (mpq_sgn(at) > 0));
            k += here;
        }
    cr_assert(k == answer->hits && answer->stop == FMB_STOP_DONE);
    mpq_clear(most);
}

static void judge_within(const fmb_mesh *m, const fmb_mesh *n, const double *motion,
                         const distances *d, support_rng *g)
{
    for (int which = 0; which < LENGTHS; which++) {
        fmb_mesh_answer trees = {.size = sizeof trees}, pairs = trees;
        fmb_mesh_options o = {.size = sizeof o, .neighbours = true, .motion = motion};
        mpq_t length;
        mpq_init(length);
        choose_length(g, d, which, length);
        char *text = mpq_get_str(NULL, 10, length);
        o.within = text;
        o.threads = (size_t)which % 3;
        must(fmb_mesh_meet(m, n, &o, &trees));
        must(fmb_mesh_meet_pairs(m, 0, d->rows, n, &o, &pairs));
        judge_hits(d, length, &trees);
        judge_hits(d, length, &pairs);
        fmb_mesh_answer_clear(&trees);
        fmb_mesh_answer_clear(&pairs);
        free(text);
        mpq_clear(length);
    }
}

static void judge_distance(const fmb_mesh *m, const fmb_mesh *n, const double *motion,
                           const distances *d)
{
    fmb_mesh_nearest near = {.size = sizeof near};
    size_t best = 0;
    mpq_t square;
    for (size_t i = 1; i < d->rows * d->columns; i++)
        best = mpq_cmp(d->square[i], d->square[best]) < 0 ? i : best;
    mpq_init(square);
    must(fmb_mesh_distance(
        m, n, &(fmb_mesh_options){.size = sizeof(fmb_mesh_options), .motion = motion}, &near));
    fmb_proximity_measure_q(near.distance, square);
    cr_assert(near.distance && near.stop == FMB_STOP_DONE && mpq_equal(square, d->square[best]));
    cr_assert(near.a == best / d->columns && near.b == best % d->columns, "%u %u, not %zu", near.a,
              near.b, best);
    fmb_proximity_free(near.distance);
    mpq_clear(square);
}

/* ---- families -------------------------------------------------------------------------------- */

typedef struct family {
    double scale; /* of coordinates from 0 to 5 */
    int away;     /* the second mesh is so far off along x, before that */
    bool real, moves;
    double level; /* z of all points, unless it is NAN */
} family;

static void place_soup(support_rng *g, const family *f, int away, soup *s)
{
    for (int i = 0; i < 3 * VERTICES; i++) {
        double x = s->point[i] + (i % 3 == 0 ? away : 0);
        if (f->real)
            x += 1e-3 * support_between(g, -1000, 1000) / 3;
        s->point[i] = i % 3 == 2 && !isnan(f->level) ? f->level : x * f->scale;
    }
}

static void judge_family(const family *f, int corners, int others, uint64_t seed)
{
    support_rng g = {seed};
    double speed[3] = {-2 * f->scale, f->scale / 2, 0}, *motion = f->moves ? speed : NULL;
    soup s, t;
    draw_soup(&g, corners, NEAR_CELLS, &s);
    draw_soup(&g, others, NEAR_CELLS + 3, &t);
    place_soup(&g, f, 0, &s);
    place_soup(&g, f, f->away, &t);
    fmb_mesh *m = mesh_of(&s), *n = mesh_of(&t);
    distances d = measure_all(m, n, motion);
    judge_within(m, n, motion, &d, &g);
    judge_distance(m, n, motion, &d);
    forget_distances(&d);
    fmb_mesh_free(m);
    fmb_mesh_free(n);
}

/* The last one but one is a sheet so small beside where it is that doubles tell no distance. */
Test(near, families)
{
    const family list[] = {{1, 0, false, false, NAN},       {1, 8, false, false, NAN},
                           {1, 3, true, false, NAN},        {1.0 / 3, 6, true, false, NAN},
                           {1, 7, false, false, 0},         {1, 6, true, true, NAN},
                           {0x1p1018, 7, true, false, NAN}, {0x1p-1070, 7, false, true, NAN},
                           {0x1p-400, 7, false, false, 1},  {1, 1 << 20, true, false, NAN}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        judge_family(&list[i], 3, i % 2 ? 3 : 4, SEED + i);
        judge_family(&list[i], 4, i % 2 ? 4 : 3, SEED + 100 + i);
    }
}

/* ---- what is refused, limits, empty meshes --------------------------------------------------- */

static bool never_goes_on(void *self, double done)
{
    (void)self;
    return done > 1;
}

Test(near, ends)
{
    static const char *const bad[] = {"-1", "-1/2", "1/0", "", "x", "0.5", "nan", "1/-2"};
    support_rng g = {SEED};
    soup s;
    draw_soup(&g, 3, CELLS, &s);
    fmb_mesh *m = mesh_of(&s), *none = NULL, *n = NULL;
    must(fmb_mesh_new(3, 0, NULL, 0, NULL, NULL, &none));
    must(fmb_mesh_placed(m, &(fmb_mesh_place){{1, 1, 1}, {9, 0, 0}}, NULL, &n));
    fmb_mesh_options o = {.size = sizeof o};
    fmb_mesh_answer answer = {.size = sizeof answer};
    fmb_mesh_nearest near = {.size = sizeof near};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        o.within = bad[i];
        cr_expect(fmb_mesh_meet(m, NULL, &o, &answer) == FMB_ERR_ARG, "%s", bad[i]);
        cr_expect(fmb_mesh_options_trouble(&o, NULL, 0) > 0);
    }
    o.within = "1";
    cr_expect(fmb_mesh_distance(m, n, &o, &near) == FMB_ERR_ARG);
    must(fmb_mesh_meet(m, none, &o, &answer));
    cr_expect(answer.hits == 0);
    o.within = NULL;
    cr_expect(fmb_mesh_distance(m, m, &o, &near) == FMB_ERR_ARG);
    cr_expect(fmb_mesh_distance(m, NULL, &o, &near) == FMB_ERR_ARG);
    must(fmb_mesh_distance(none, m, &o, &near));
    cr_expect(!near.distance && near.stop == FMB_STOP_DONE);
    o.progress = never_goes_on;
    must(fmb_mesh_distance(m, n, &o, &near));
    cr_expect(!near.distance && near.stop == FMB_STOP_CANCELLED);
    o.progress = NULL;
    o.max_bytes = 1;
    must(fmb_mesh_distance(m, n, &o, &near));
    cr_expect(!near.distance && near.stop == FMB_STOP_BYTES);
    fmb_mesh_free(m);
    fmb_mesh_free(n);
    fmb_mesh_free(none);
}

/* Each allocation fails once, where no doubles tell: every answer is an exact one. */
Test(near, memory)
{
    const double flat[] = {0, 0, 1, 0x1p-400, 0, 1, 0, 0x1p-400, 1};
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_mesh *m = NULL, *n = NULL;
    must(fmb_mesh_new(3, 3, flat, 1, (const uint32_t[]){0, 1, 2}, NULL, &m));
    must(fmb_mesh_placed(m, &(fmb_mesh_place){{1, 1, 1}, {0x1p-390, 0, 0}}, NULL, &n));
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        fmb_mesh_nearest near = {.size = sizeof near};
        fmb_mesh_options o = {.size = sizeof o, .mem = &mem};
        hook_arm(&h, k, false);
        st = fmb_mesh_distance(m, n, &o, &near);
        hook_calm(&h);
        cr_assert(st == FMB_OK ? near.distance != NULL : st == FMB_ERR_MEMORY && !near.distance);
        fmb_proximity_free(near.distance);
        cr_assert(h.live == 0, "%zu: %zu bytes", k, h.live);
    }
    fmb_mesh_free(m);
    fmb_mesh_free(n);
}
