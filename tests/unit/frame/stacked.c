/* stacked.c: polytopes given by rows meet frames, and each other. */
#include <criterion/criterion.h>
#include <string.h>

#include "fault/hook.h"
#include "meet.h"
#include "property/random/rows.h"
#include "support/support.h"

static const double unit3[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/* |x - a| + |y| + |z| <= 1, in variables of its own. */
static fmb_system *octahedron(double a)
{
    fmb_system *s = rows_none(3);
    for (int k = 0; k < 8; k++) {
        double row[] = {k & 1 ? -1 : 1, k & 2 ? -1 : 1, k & 4 ? -1 : 1};
        must(fmb_system_add(s, row, FMB_LE, 1 + row[0] * a));
    }
    return s;
}

/* Does a unit cube at (a, b, b) meet the octahedron about 0? In world coordinates and all. */
static bool cube_meets(double a, double b, const fmb_system *body)
{
    double corner[] = {a, b, b};
    fmb_frame cube = {FMB_CUBOID, 3, 3, corner, unit3, NULL};
    fmb_system *s = meeting(&cube, 1, FMB_COORDINATES_WORLD);
    fmb_system *t = meeting(&cube, 1, FMB_COORDINATES_ALL);
    must(fmb_system_join(s, body, NULL));
    must(fmb_system_join(t, body, NULL));
    bool yes = is_feasible(s);
    cr_expect_eq(is_feasible(t), yes);
    fmb_system_free(s);
    fmb_system_free(t);
    return yes;
}

Test(stacked, frame_and_rows)
{
    fmb_system *body = octahedron(0);
    cr_expect(cube_meets(0, 0, body));
    cr_expect(cube_meets(1, 0, body), "corner on corner");
    cr_expect_not(cube_meets(1 + 0x1p-52, 0, body));
    cr_expect(cube_meets(0.5, 0.25, body), "corner on facet");
    cr_expect_not(cube_meets(0.5, 0.25 + 0x1p-54, body));
    fmb_system_free(body);
}

Test(stacked, rows_and_rows)
{
    for (int k = 0; k < 3; k++) {
        const double away[] = {1, 2, 2 + 0x1p-51};
        fmb_system *s = octahedron(0), *other = octahedron(away[k]);
        must(fmb_system_join(s, other, NULL));
        cr_expect_eq(fmb_system_rows(s), 16u);
        cr_expect_eq(is_feasible(s), k < 2);
        fmb_system_free(s);
        fmb_system_free(other);
    }
}

/* A frame in world coordinates is a polytope like any other: stacking two is asking for both. A
 * moving one brings its time along. */
Test(stacked, frames_as_rows)
{
    support_rng g = {11};
    int yes = 0, asked = 0;
    for (int round = 0; round < 200; round++) {
        double number[2][15];
        fmb_frame f[2];
        for (int k = 0; k < 30; k++)
            number[k / 15][k % 15] = support_between(&g, -3, 3);
        for (int k = 0; k < 2; k++)
            f[k] = (fmb_frame){(fmb_shape)support_between(&g, 0, 1),
                               3,
                               3 - support_chance(&g, 30),
                               number[k],
                               number[k] + 3,
                               k == 0 && support_chance(&g, 50) ? number[k] + 12 : NULL};
        fmb_system *s = NULL, *other = NULL;
        if (fmb_system_from_frames(f, 1, FMB_COORDINATES_WORLD, FMB_CONTACT_CLOSED, NULL, &s) ==
                FMB_OK &&
            fmb_system_from_frames(f + 1, 1, FMB_COORDINATES_WORLD, FMB_CONTACT_CLOSED, NULL,
                                   &other) == FMB_OK) {
            must(fmb_system_join(s, other, NULL));
            bool verdict = is_feasible(s);
            cr_expect_eq(verdict, meet(f, 2, FMB_COORDINATES_EACH), "round %d", round);
            yes += verdict;
            asked++;
        }
        fmb_system_free(s);
        fmb_system_free(other);
    }
    cr_expect(asked > 150 && yes > 20 && yes < asked - 20, "%d of %d", yes, asked);
}

/* ---- fmb_system_join ------------------------------------------------------------------------- */

static fmb_system *one_row(void)
{
    fmb_system *s = rows_none(2);
    must(fmb_system_add_int(s, (int64_t[]){2, 3}, FMB_LT, 7));
    must(fmb_system_set_label(s, 0, "cap"));
    return s;
}

Test(stacked, variables_by_number)
{
    fmb_system *s = rows_none(3), *more = one_row(), *want = rows_none(3);
    must(fmb_system_join(s, more, (int[]){2, 0}));
    must(fmb_system_join(s, more, (int[]){1, 1}));
    must(fmb_system_add_int(want, (int64_t[]){3, 0, 2}, FMB_LT, 7));
    must(fmb_system_add_int(want, (int64_t[]){0, 5, 0}, FMB_LT, 7));
    for (size_t i = 0; i < 2; i++) {
        cr_expect(rows_equal(s, i, want, i));
        cr_expect_str_eq(fmb_system_label(s, i), "cap");
    }
    must(fmb_system_join(s, s, NULL));
    cr_expect_eq(fmb_system_rows(s), 4u);
    cr_expect(rows_equal(s, 3, want, 1));
    fmb_system_free(s);
    fmb_system_free(more);
    fmb_system_free(want);
}

Test(stacked, arguments)
{
    fmb_system *s = rows_none(1), *more = one_row();
    cr_expect_eq(fmb_system_join(s, more, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_join(s, more, (int[]){0, 1}), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_join(s, more, (int[]){-1, 0}), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_join(NULL, more, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_join(s, NULL, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_rows(s), 0u);
    fmb_system_free(s);
    fmb_system_free(more);
}

/* Whichever request fails, s is as it was. */
Test(stacked, memory)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_system *more = octahedron(0);
    must(fmb_system_set_label(more, 3, "label"));
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        fmb_system *s = NULL;
        must(fmb_system_new(3, &mem, &s));
        hook_arm(&h, k, false);
        st = fmb_system_join(s, more, NULL);
        cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY);
        cr_assert_eq(fmb_system_rows(s), st == FMB_OK ? 8u : 0u);
        hook_calm(&h);
        fmb_system_free(s);
        cr_assert_eq(h.live, 0);
    }
    fmb_system_free(more);
}
