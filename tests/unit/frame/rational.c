/* rational.c: frames with rationals, open frames, flat frames, and any number of dimensions. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "fault/hook.h"
#include "meet.h"
#include "property/random/rows.h"
#include "support/support.h"

static const fmb_coordinates ALL[] = {FMB_COORDINATES_EACH, FMB_COORDINATES_WORLD,
                                      FMB_COORDINATES_LAST, FMB_COORDINATES_ALL};
static const double unit[] = {1, 0, 0, 1};

static bool meet_q(const fmb_frame_q *f, fmb_coordinates in, fmb_contact contact)
{
    fmb_system *s = NULL;
    must(fmb_system_from_frames_q(f, 2, in, contact, NULL, &s));
    bool yes = is_feasible(s);
    fmb_system_free(s);
    return yes;
}

/* ---- doubles are rationals ------------------------------------------------------------------- */

static void expect_same(const fmb_system *a, const fmb_system *b)
{
    cr_assert_eq(fmb_system_rows(a), fmb_system_rows(b));
    cr_assert_eq(fmb_system_dim(a), fmb_system_dim(b));
    for (size_t i = 0; i < fmb_system_rows(a); i++)
        cr_expect(rows_equal(a, i, b, i), "row %zu", i);
    for (int j = 0; j < fmb_system_dim(a); j++)
        cr_expect_str_eq(fmb_system_name(a, j), fmb_system_name(b, j));
}

/* A double of any size, some of them denormal, some 0. */
static double any_double(support_rng *g)
{
    double m = support_between(g, -1000000, 1000000);
    return support_chance(g, 10) ? 0 : ldexp(m, support_between(g, -1074, 1000));
}

Test(rational, doubles_of_all_sizes)
{
    support_rng g = {5};
    for (int round = 0; round < 100; round++) {
        double number[2][15];
        fmb_frame f[2];
        fmb_frame_q q[2];
        for (int k = 0; k < 2; k++) {
            for (int i = 0; i < 15; i++)
                number[k][i] = any_double(&g);
            f[k] = (fmb_frame){(fmb_shape)(round >> k & 1),
                               3,
                               support_between(&g, 0, 3),
                               number[k],
                               number[k] + 3,
                               support_chance(&g, 30) ? number[k] + 12 : NULL};
            q[k] = rational_of(&f[k]);
        }
        for (size_t i = 0; i < 4; i++) {
            fmb_system *s = NULL, *t = NULL;
            fmb_contact contact = (fmb_contact)(round >> 2 & 1);
            fmb_status st = fmb_system_from_frames(f, 2, ALL[i], contact, NULL, &s);
            cr_assert_eq(st, fmb_system_from_frames_q(q, 2, ALL[i], contact, NULL, &t));
            if (st == FMB_OK)
                expect_same(s, t);
            fmb_system_free(s);
            fmb_system_free(t);
        }
        rational_free(&q[0]);
        rational_free(&q[1]);
    }
}

/* Squares with sides of a third: the second begins where the first ends, or 10^-30 behind. */
Test(rational, thirds)
{
    fmb_frame_q f[2];
    for (int k = 0; k < 2; k++) {
        f[k] = rational_new(FMB_CUBOID, 2, 2, false);
        mpq_set_ui(f[k].origin[0], 1u + (unsigned)k, 3);
        mpq_canonicalize(f[k].origin[0]);
        mpq_set_ui(f[k].axes[0], 1, 3);
        mpq_set_ui(f[k].axes[3], 1, 3);
    }
    mpq_t hair;
    mpq_init(hair);
    mpq_set_str(hair, "1/1000000000000000000000000000000", 10);
    for (size_t i = 0; i < 4; i++) {
        cr_expect(meet_q(f, ALL[i], FMB_CONTACT_CLOSED));
        cr_expect_not(meet_q(f, ALL[i], FMB_CONTACT_OPEN));
    }
    mpq_add(f[1].origin[0], f[1].origin[0], hair);
    for (size_t i = 0; i < 4; i++)
        cr_expect_not(meet_q(f, ALL[i], FMB_CONTACT_CLOSED));
    mpq_clear(hair);
    rational_free(&f[0]);
    rational_free(&f[1]);
}

Test(rational, arguments)
{
    fmb_frame_q good = rational_new(FMB_CUBOID, 2, 2, false),
                bad[5] = {good, good, good, good, good};
    fmb_system *s = NULL;
    bad[0].naxes = 3;
    bad[1].shape = (fmb_shape)4;
    bad[2].origin = NULL;
    bad[3].axes = NULL;
    bad[4].dim = 1;
    for (size_t k = 0; k < 5; k++) {
        fmb_frame_q f[] = {good, bad[k]};
        cr_expect_eq(
            fmb_system_from_frames_q(f, 2, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, NULL, &s),
            FMB_ERR_ARG);
    }
    cr_expect_eq(
        fmb_system_from_frames_q(NULL, 2, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, NULL, &s),
        FMB_ERR_ARG);
    cr_expect_eq(fmb_system_from_frames_q(&good, 1, FMB_COORDINATES_ALL, (fmb_contact)2, NULL, &s),
                 FMB_ERR_ARG);
    cr_expect_eq(
        fmb_system_from_frames_q(&good, 1, FMB_COORDINATES_WORLD, FMB_CONTACT_CLOSED, NULL, &s),
        FMB_ERR_ARG, "no edge has a length");
    mpz_ptr den = mpq_denref(good.axes[3]);
    mpz_set_ui(den, 0);
    for (size_t i = 0; i < 4; i++)
        cr_expect_eq(fmb_system_from_frames_q(&good, 1, ALL[i], FMB_CONTACT_CLOSED, NULL, &s),
                     FMB_ERR_ARG);
    cr_expect_null(s);
    mpz_set_ui(den, 1);
    rational_free(&good);
}

/* Numbers need not be in lowest terms, and a sign may stand below: 6/-4 is -3/2. */
Test(rational, numbers_as_they_come)
{
    fmb_frame_q f[2];
    for (int k = 0; k < 2; k++) {
        f[k] = rational_new(FMB_CUBOID, 1, 1, false);
        mpq_set_si(f[k].axes[0], 1, 1);
    }
    mpz_set_si(mpq_numref(f[0].origin[0]), 6);
    mpz_set_si(mpq_denref(f[0].origin[0]), -4);
    const struct {
        long num;
        bool meets;
    } table[] = {{-5, true}, {-6, false}, {-1, true}, {0, false}};
    for (size_t t = 0; t < 4; t++)
        for (size_t i = 0; i < 4; i++) {
            mpq_set_si(f[1].origin[0], table[t].num, 2);
            cr_expect_eq(meet_q(f, ALL[i], FMB_CONTACT_CLOSED), table[t].meets, "%zu %zu", t, i);
        }
    mpq_set_si(f[0].origin[0], 0, 1);
    rational_free(&f[0]);
    rational_free(&f[1]);
}

Test(rational, memory)
{
    double o[] = {0, 0}, axes[] = {1, 2, 3, -1}, v[] = {1, 1};
    fmb_frame f[] = {{FMB_CUBOID, 2, 2, o, axes, v}, {FMB_SIMPLEX, 2, 1, o, unit, NULL}};
    fmb_frame_q q[] = {rational_of(&f[0]), rational_of(&f[1])};
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        fmb_system *s = NULL;
        hook_arm(&h, k, false);
        st = fmb_system_from_frames_q(q, 2, FMB_COORDINATES_ALL, FMB_CONTACT_OPEN, &mem, &s);
        cr_assert(st == FMB_OK ? s != NULL : st == FMB_ERR_MEMORY && s == NULL);
        hook_calm(&h);
        fmb_system_free(s);
        cr_assert_eq(h.live, 0);
    }
    rational_free(&q[0]);
    rational_free(&q[1]);
}

/* ---- open ------------------------------------------------------------------------------------ */

/* A square and what meets it: with its rim, and without. */
Test(rational, open)
{
    double here[] = {0, 0}, touching[] = {1, 0}, inside[] = {0.5, 0.5}, beyond[] = {1.5, 0.5};
    double right[] = {1, 0}, left[] = {-0.5, 0}, in[] = {-1, 0}, far[] = {2, 0};
    fmb_frame square = {FMB_CUBOID, 2, 2, here, unit, NULL};
    const struct {
        fmb_frame other;
        bool closed, open;
    } table[] = {
        {{FMB_CUBOID, 2, 2, touching, unit, NULL}, true, false},
        {{FMB_CUBOID, 2, 2, inside, unit, NULL}, true, true},
        {{FMB_SIMPLEX, 2, 2, inside, unit, NULL}, true, true},
        {{FMB_SIMPLEX, 2, 2, touching, unit, NULL}, true, false},
        {{FMB_CUBOID, 2, 0, inside, NULL, NULL}, true, true},    /* a point is its own interior */
        {{FMB_CUBOID, 2, 0, touching, NULL, NULL}, true, false}, /* but this one is on the rim */
        {{FMB_CUBOID, 2, 1, inside, right, NULL}, true, true},
        {{FMB_CUBOID, 2, 1, beyond, left, NULL}, true, false}, /* ends on the rim */
        {{FMB_CUBOID, 2, 1, here, right, NULL}, true, false},  /* runs along the rim */
        {{FMB_CUBOID, 2, 2, far, unit, in}, true, false},      /* arrives at t = 1 */
        {{FMB_CUBOID, 2, 2, beyond, unit, in}, true, true},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        for (size_t i = 0; i < 4; i++) {
            fmb_frame f[] = {square, table[k].other}, g[] = {table[k].other, square};
            cr_expect_eq(meet(f, 2, ALL[i]), table[k].closed, "%zu %zu", k, i);
            cr_expect_eq(meet_open(f, 2, ALL[i]), table[k].open, "%zu %zu", k, i);
            cr_expect_eq(meet_open(g, 2, ALL[i]), table[k].open, "%zu %zu", k, i);
        }
}

/* Parallel edges: the segment from (0, 0) to (3, 6), whose ends are not inside of it. */
Test(rational, degenerate)
{
    double here[] = {0, 0}, edges[] = {1, 2, 2, 4}, nothing[] = {0, 0, 0, 0};
    double end[] = {3, 6}, middle[] = {1.5, 3}, beside[] = {1.5, 3 + 0x1p-51};
    fmb_frame flat = {FMB_CUBOID, 2, 2, here, edges, NULL};
    const fmb_coordinates any[] = {FMB_COORDINATES_EACH, FMB_COORDINATES_ALL};
    const struct {
        const double *point;
        bool closed, open;
    } table[] = {{end, true, false}, {middle, true, true}, {beside, false, false}};
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < 2; i++) {
            fmb_frame f[] = {flat, {FMB_SIMPLEX, 2, 2, table[k].point, nothing, NULL}};
            cr_expect_eq(meet(f, 2, any[i]), table[k].closed, "%zu %zu", k, i);
            cr_expect_eq(meet_open(f, 2, any[i]), table[k].open, "%zu %zu", k, i);
        }
}

/* ---- any dimension --------------------------------------------------------------------------- */

/* The unit simplex and a cube with its corner at (a, ..., a), the first `naxes` of its edges: they
 * share points iff dim a <= 1, and inner ones iff dim a < 1. */
static void corner(int dim, int naxes, const char *change, bool closed, bool open)
{
    fmb_frame_q f[] = {rational_new(FMB_SIMPLEX, dim, dim, false),
                       rational_new(FMB_CUBOID, dim, naxes, false)};
    mpq_t delta;
    mpq_init(delta);
    mpq_set_str(delta, change, 10);
    for (int i = 0; i < dim; i++) {
        mpq_set_ui(f[0].axes[i * dim + i], 1, 1);
        if (i < naxes)
            mpq_set_ui(f[1].axes[i * dim + i], 1, 1);
        mpq_set_ui(f[1].origin[i], 1, (unsigned long)dim);
        mpq_add(f[1].origin[i], f[1].origin[i], delta);
    }
    for (size_t i = 0; i < 4; i++) {
        cr_expect_eq(meet_q(f, ALL[i], FMB_CONTACT_CLOSED), closed, "%d %d %zu", dim, naxes, i);
        cr_expect_eq(meet_q(f, ALL[i], FMB_CONTACT_OPEN), open, "%d %d %zu", dim, naxes, i);
    }
    mpq_clear(delta);
    rational_free(&f[0]);
    rational_free(&f[1]);
}

Test(rational, dimensions)
{
    for (int dim = 1; dim <= 16; dim++)
        for (int naxes = dim; naxes >= 0; naxes -= 1 + dim / 2) {
            corner(dim, naxes, "0", true, false);
            corner(dim, naxes, "1/1000000000000000000000", false, false);
            corner(dim, naxes, "-1/1000000000000000000000", true, true);
        }
}
