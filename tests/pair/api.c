/* api.c: fmb_pair_test as its header tells it. */
#include <criterion/criterion.h>

#include <fmb/pair.h>

#include "../random/rows.h"

static const double UNIT[4] = {1, 0, 0, 1};

static fmb_frame square(const double *origin)
{
    return (fmb_frame){FMB_CUBOID, 2, 2, origin, UNIT, NULL};
}

Test(pair, squares_that_overlap_touch_and_are_apart)
{
    const double zero[2] = {0, 0}, place[3][2] = {{0.5, 0.25}, {1, 0}, {1.5, 0}};
    const fmb_verdict closed[3] = {FMB_FEASIBLE, FMB_FEASIBLE, FMB_INFEASIBLE};
    const fmb_verdict open[3] = {FMB_FEASIBLE, FMB_INFEASIBLE, FMB_INFEASIBLE};
    fmb_frame p[3], q[3];
    for (int i = 0; i < 3; i++) {
        p[i] = square(zero);
        q[i] = square(place[i]);
    }
    for (int contact = 0; contact < 2; contact++) {
        fmb_pair_options o = fmb_pair_options_default();
        o.contact = (fmb_contact)contact;
        fmb_pair *k = NULL;
        fmb_verdict verdict[3];
        double world[3][2][2], inside[3][2][2], time[3][2], witness[3][2];
        const fmb_pair_answers out = {verdict, &world[0][0][0], &inside[0][0][0], &time[0][0],
                                      &witness[0][0]};
        must(fmb_pair_new(2, &o, NULL, &k));
        must(fmb_pair_test(k, 3, p, q, &out));
        for (int i = 0; i < 3; i++)
            cr_expect_eq(verdict[i], contact ? open[i] : closed[i], "%d %d", contact, i);
        cr_expect_eq(fmb_pair_count(k).pairs, 3u);
        cr_expect_float_eq(world[0][0][0], 0.5, 1e-12);
        cr_expect_float_eq(world[0][1][1], 1, 1e-12);
        cr_expect_float_eq(inside[0][0][1], 0.5, 1e-12);
        cr_expect_float_eq(inside[0][1][1], 0.75, 1e-12);
        cr_expect_eq(time[0][1], 1);
        fmb_pair_free(k);
    }
}
