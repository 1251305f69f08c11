/* frame.c: systems from frames, in all choices of coordinates; fmb_check accepts every verdict. */
#include <criterion/criterion.h>
#include <limits.h>
#include <string.h>

#include <fmb/frame.h>
#include <fmb/gmp.h>

#include "fault/hook.h"
#include "meet.h"
#include "property/random/rows.h"

static const fmb_coordinates ALL[] = {FMB_COORDINATES_EACH, FMB_COORDINATES_WORLD,
                                      FMB_COORDINATES_LAST, FMB_COORDINATES_ALL};

static const double unit[] = {1, 0, 0, 1};

/* Two unit squares side by side, the second dx away: they touch at 1, and not a hair beyond. */
static bool squares_meet(double dx, fmb_coordinates in)
{
    double here[] = {0, 0}, there[] = {dx, 0};
    fmb_frame f[] = {{FMB_CUBOID, 2, 2, here, unit, NULL}, {FMB_CUBOID, 2, 2, there, unit, NULL}};
    return meet(f, 2, in);
}

Test(frame, touching)
{
    for (size_t i = 0; i < 4; i++) {
        cr_expect(squares_meet(0.5, ALL[i]));
        cr_expect(squares_meet(1, ALL[i]));
        cr_expect(squares_meet(-1, ALL[i]));
        cr_expect_not(squares_meet(1 + 0x1p-52, ALL[i]));
    }
}

/* The corner of a triangle that a square lacks. */
Test(frame, simplex)
{
    double here[] = {0, 0}, there[] = {0.5, 0.5}, beyond[] = {0.5, 0.5 + 0x1p-53};
    fmb_frame f[] = {{FMB_SIMPLEX, 2, 2, here, unit, NULL}, {FMB_CUBOID, 2, 2, there, unit, NULL}};
    for (size_t i = 0; i < 4; i++) {
        f[1].origin = there;
        cr_expect(meet(f, 2, ALL[i]));
        f[1].origin = beyond;
        cr_expect_not(meet(f, 2, ALL[i]));
    }
}

/* It arrives at t = 1, or a little later. */
Test(frame, moving)
{
    double here[] = {0, 0}, there[] = {3, 0}, fast[] = {-2, 0}, slow[] = {-2 + 0x1p-52, 0};
    fmb_frame f[] = {{FMB_CUBOID, 2, 2, here, unit, NULL}, {FMB_CUBOID, 2, 2, there, unit, fast}};
    for (size_t i = 0; i < 4; i++) {
        f[1].speed = fast;
        cr_expect(meet(f, 2, ALL[i]));
        f[1].speed = slow;
        cr_expect_not(meet(f, 2, ALL[i]));
    }
}

/* A segment through a square, one beside it, a point on its rim; the square comes last and first.
 */
Test(frame, flat)
{
    double here[] = {0, 0}, through[] = {-1, 0.5}, beside[] = {-1, 1.5}, rim[] = {1, 0.5};
    double right[] = {5, 0};
    fmb_frame square = {FMB_CUBOID, 2, 2, here, unit, NULL};
    fmb_frame other[] = {{FMB_CUBOID, 2, 1, through, right, NULL},
                         {FMB_SIMPLEX, 2, 1, through, right, NULL},
                         {FMB_CUBOID, 2, 1, beside, right, NULL},
                         {FMB_CUBOID, 2, 0, rim, NULL, NULL},
                         {FMB_SIMPLEX, 2, 0, beside, NULL, NULL}};
    const bool truth[] = {true, true, false, true, false};
    for (size_t k = 0; k < 5; k++)
        for (size_t i = 0; i < 4; i++) {
            fmb_frame f[] = {square, other[k]}, g[] = {other[k], square};
            cr_expect_eq(meet(f, 2, ALL[i]), truth[k], "%zu %zu", k, i);
            cr_expect_eq(meet(g, 2, ALL[i]), truth[k], "%zu %zu", k, i);
        }
}

/* Three segments of a triangle meet two by two, but have no common point. */
Test(frame, three)
{
    double a[] = {0, 0}, b[] = {2, 0}, ab[] = {2, 0}, ac[] = {0, 2}, bc[] = {-2, 2};
    fmb_frame f[] = {{FMB_CUBOID, 2, 1, a, ab, NULL},
                     {FMB_CUBOID, 2, 1, a, ac, NULL},
                     {FMB_CUBOID, 2, 1, b, bc, NULL}};
    for (size_t i = 0; i < 4; i++) {
        cr_expect_not(meet(f, 3, ALL[i]));
        cr_expect(meet(f, 2, ALL[i]) && meet(f + 1, 2, ALL[i]));
    }
}

/* No room at all: everything is the one point. */
Test(frame, no_dimension)
{
    fmb_frame f[] = {{FMB_CUBOID, 0, 0, NULL, NULL, NULL}, {FMB_SIMPLEX, 0, 0, NULL, NULL, NULL}};
    for (size_t i = 0; i < 4; i++)
        cr_expect(meet(f, 2, ALL[i]));
}

/* 3D cuboid against simplex, both moving: numbers of rows and variables, their order and names. */
Test(frame, shape_of_system)
{
    double o[] = {0, 0, 0}, axes[] = {2, 0, 0, 0, 2, 0, 0, 0, 2}, v[] = {1, 1, 0};
    fmb_frame f[] = {{FMB_CUBOID, 3, 3, o, axes, v}, {FMB_SIMPLEX, 3, 3, o, axes, NULL}};
    fmb_system *s = meeting(f, 2, FMB_COORDINATES_LAST);
    fmb_system *want = rows_none(4);
    /* c_i of A = c_i of B - t v_i / 2 */
    static const int64_t row[][5] = {{-2, 0, 0, 1, 0}, {0, -2, 0, 1, 0}, {0, 0, -1, 0, 0},
                                     {2, 0, 0, -1, 2}, {0, 2, 0, -1, 2}, {0, 0, 1, 0, 1},
                                     {-1, 0, 0, 0, 0}, {0, -1, 0, 0, 0}, {0, 0, -1, 0, 0},
                                     {1, 1, 1, 0, 1},  {0, 0, 0, -1, 0}, {0, 0, 0, 1, 1}};
    const size_t rows = sizeof row / sizeof *row;
    cr_assert_eq(fmb_system_rows(s), rows);
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    for (size_t i = 0; i < rows; i++) {
        must(fmb_system_add_int(want, row[i], FMB_LE, row[i][4]));
        cr_assert_eq(fmb_system_terms(s, i), fmb_system_terms(want, i), "row %zu", i);
        fmb_system_term_q(s, i, 0, a);
        fmb_system_term_q(want, i, 0, b);
        mpq_div(b, a, b);
        fmb_system_rhs_q(want, i, a);
        mpq_mul(b, b, a);
        fmb_system_rhs_q(s, i, a);
        cr_expect(mpq_equal(a, b), "row %zu", i);
    }
    mpq_clears(a, b, NULL);
    cr_expect_str_eq(fmb_system_name(s, 0), "c1");
    cr_expect_str_eq(fmb_system_name(s, 3), "t");
    fmb_system_free(s);
    fmb_system_free(want);
}

Test(frame, arguments)
{
    double o[] = {0, 0}, bad[] = {0, 1.0 / 0.0}, same[] = {1, 2, 2, 4};
    fmb_frame good = {FMB_CUBOID, 2, 2, o, unit, NULL};
    fmb_frame wrong[] = {{FMB_CUBOID, 2, 3, o, unit, NULL},
                         {FMB_CUBOID, 2, -1, o, unit, NULL},
                         {FMB_CUBOID, -1, 0, o, unit, NULL},
                         {FMB_CUBOID, 2, 2, bad, unit, NULL},
                         {FMB_CUBOID, 2, 2, NULL, unit, NULL},
                         {FMB_CUBOID, 2, 2, o, NULL, NULL},
                         {FMB_CUBOID, 2, 2, o, unit, bad},
                         {(fmb_shape)7, 2, 2, o, unit, NULL},
                         {FMB_CUBOID, 1, 1, o, unit, NULL},
                         {FMB_CUBOID, FMB_FRAME_MOST_DIM + 1, 0, o, NULL, NULL}};
    fmb_system *s = NULL;
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        fmb_frame f[] = {good, wrong[k]};
        for (size_t i = 0; i < 4; i++)
            cr_expect_eq(fmb_system_from_frames(f, 2, ALL[i], FMB_CONTACT_CLOSED, NULL, &s),
                         FMB_ERR_ARG, "%zu", k);
    }
    const fmb_frame huge = {FMB_CUBOID, INT_MAX, INT_MAX, o, unit, NULL};
    for (size_t i = 0; i < 4; i++)
        cr_expect_eq(fmb_system_from_frames(&huge, 1, ALL[i], FMB_CONTACT_CLOSED, NULL, &s),
                     FMB_ERR_ARG);
    cr_expect_eq(
        fmb_system_from_frames(&good, 1, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, NULL),
        FMB_ERR_ARG);
    cr_expect_eq(fmb_system_from_frames(&good, 1, FMB_COORDINATES_EACH, (fmb_contact)2, NULL, &s),
                 FMB_ERR_ARG);
    cr_expect_eq(
        fmb_system_from_frames(&good, 0, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, &s),
        FMB_ERR_ARG);
    cr_expect_eq(
        fmb_system_from_frames(NULL, 1, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, &s),
        FMB_ERR_ARG);
    cr_expect_eq(fmb_system_from_frames(&good, 1, (fmb_coordinates)4, FMB_CONTACT_CLOSED, NULL, &s),
                 FMB_ERR_ARG);
    fmb_frame f[] = {{FMB_CUBOID, 2, 2, o, same, NULL}, good};
    cr_expect_eq(fmb_system_from_frames(f, 2, FMB_COORDINATES_WORLD, FMB_CONTACT_CLOSED, NULL, &s),
                 FMB_ERR_ARG);
    cr_expect_eq(fmb_system_from_frames(f, 2, FMB_COORDINATES_LAST, FMB_CONTACT_CLOSED, NULL, &s),
                 FMB_ERR_ARG);
    cr_expect_null(s);
    cr_expect(meet(f, 2, FMB_COORDINATES_EACH));
}

Test(frame, memory)
{
    double o[] = {0, 0}, axes[] = {1, 2, 3, -1}, v[] = {1, 1};
    fmb_frame f[] = {{FMB_CUBOID, 2, 2, o, axes, v}, {FMB_SIMPLEX, 2, 1, o, unit, NULL}};
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    for (size_t i = 0; i < 4; i++) {
        fmb_status st = FMB_ERR_MEMORY;
        for (size_t k = 1; st != FMB_OK; k++) {
            fmb_system *s = NULL;
            hook_arm(&h, k, false);
            st = fmb_system_from_frames(f, 2, ALL[i], FMB_CONTACT_CLOSED, &mem, &s);
            cr_assert(st == FMB_OK ? s != NULL : st == FMB_ERR_MEMORY && s == NULL);
            hook_calm(&h);
            fmb_system_free(s);
            cr_assert_eq(h.live, 0);
        }
    }
}

/* Small random frames, some flat, some moving: all coordinates agree. */
Test(frame, coordinates_agree)
{
    unsigned x = 7;
    int yes = 0;
    for (int round = 0; round < 400; round++) {
        double number[2][16];
        for (int k = 0; k < 32; k++) {
            x = x * 1103515245u + 12345u;
            number[k / 16][k % 16] = (double)(int)((x >> 16) % 7) - 3;
        }
        fmb_frame f[2];
        for (int k = 0; k < 2; k++)
            f[k] = (fmb_frame){(fmb_shape)((x >> (20 + k)) & 1),
                               3,
                               3 - (int)((x >> (22 + k)) & 1),
                               number[k],
                               number[k] + 3,
                               round & 1 ? number[k] + 12 : NULL};
        fmb_system *s = NULL;
        bool verdict = meet(f, 2, FMB_COORDINATES_EACH);
        yes += verdict;
        for (size_t i = 1; i < 4; i++)
            if (fmb_system_from_frames(f, 2, ALL[i], FMB_CONTACT_CLOSED, NULL, &s) == FMB_OK) {
                fmb_system_free(s);
                cr_expect_eq(meet(f, 2, ALL[i]), verdict, "round %d", round);
            }
    }
    cr_expect(yes > 40 && yes < 360, "%d", yes);
}
