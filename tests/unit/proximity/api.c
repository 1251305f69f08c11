/* api.c: wrong arguments, limits, lengths and texts of distance, depth and common points. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>

#include "bodies.h"
#include "support/must.h"

static fmb_solver *solver;

static void open_solver(void)
{
    must(fmb_solver_new(NULL, NULL, &solver));
}

static void close_solver(void)
{
    fmb_solver_free(solver);
}

TestSuite(proximity_api, .init = open_solver, .fini = close_solver);

Test(proximity_api, arguments)
{
    const double x[2] = {0, 0}, infinite[2] = {0, INFINITY};
    fmb_frame point = {.shape = FMB_CUBOID, .dim = 2, .naxes = 0, .origin = x};
    fmb_frame f[2] = {point, point}, bad[2] = {point, point}, none[2] = {point, point};
    fmb_proximity *p = NULL;
    fmb_generators *g = NULL;
    fmb_system *row = NULL;
    bad[1].origin = infinite;
    none[0].dim = none[1].dim = 0;
    cr_expect(fmb_distance(NULL, f, FMB_NORM_MAX, &p, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_distance(solver, NULL, FMB_NORM_MAX, &p, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_distance(solver, f, FMB_NORM_MAX, NULL, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_distance(solver, f, (fmb_norm)2, &p, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_distance(solver, bad, FMB_NORM_MAX, &p, NULL) == FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(solver), "f[1]: origin[1] is not finite");
    cr_expect(fmb_depth(solver, bad, FMB_NORM_MAX, &p, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_depth(solver, none, FMB_NORM_MAX, &p, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_separate(solver, f, (fmb_contact)2, &row, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_common(solver, bad, &g, NULL) == FMB_ERR_ARG);
    cr_expect(!p && !g && !row);
    cr_expect(!fmb_separates(f, FMB_CONTACT_CLOSED, NULL));
    must(fmb_depth(solver, f, FMB_NORM_EUCLIDEAN, &p, NULL)); /* a point on itself */
    cr_expect(p && fmb_proximity_length(p) == 0);
    fmb_proximity_free(p);
    fmb_proximity_free(NULL);
    cr_expect(fmb_proximity_length(NULL) == 0);
}

/* 3, 4, 5 at the ends of doubles, where squares are no doubles. */
Test(proximity_api, lengths_at_every_scale)
{
    static const double unit[] = {0x1p-1074, 0x1p-1040, 1e-165, 1, 1e155, 0x1p1020};
    for (size_t i = 0; i < sizeof unit / sizeof *unit; i++) {
        double x = unit[i], a[2] = {0, 0}, b[2] = {3 * x, 4 * x};
        fmb_frame f[2] = {{FMB_CUBOID, 2, 0, a, a, NULL}, {FMB_CUBOID, 2, 0, b, b, NULL}};
        fmb_proximity *p = NULL;
        must(fmb_distance(solver, f, FMB_NORM_EUCLIDEAN, &p, NULL));
        cr_expect_float_eq(fmb_proximity_length(p), 5 * x, x * 0x1p-50, "%a", x);
        fmb_proximity_free(p);
    }
}

Test(proximity_api, limits)
{
    support_rng g = {24};
    bodies b;
    bodies_draw(&g, 3, false, 20, &b);
    fmb_options o = {.size = sizeof o};
    fmb_solver *small = NULL;
    o.max_bytes = 100;
    must(fmb_solver_new(&o, NULL, &small));
    for (int verb = 0; verb < 4; verb++) {
        fmb_proximity *p = NULL;
        fmb_generators *common = NULL;
        fmb_system *row = NULL;
        fmb_result r = {.size = sizeof r};
        must(verb == 0   ? fmb_distance(small, b.f, FMB_NORM_EUCLIDEAN, &p, &r)
             : verb == 1 ? fmb_depth(small, b.f, FMB_NORM_MAX, &p, &r)
             : verb == 2 ? fmb_common(small, b.f, &common, &r)
                         : fmb_separate(small, b.f, FMB_CONTACT_CLOSED, &row, &r));
        cr_expect(r.verdict == FMB_UNKNOWN && r.stop == FMB_STOP_BYTES, "%d", verb);
        cr_expect(!p && !common && !row);
    }
    fmb_solver_free(small);
}

static void expect_text(const char *want, size_t length, const char *text)
{
    cr_expect_str_eq(text, want);
    cr_expect_eq(length, strlen(want));
}

/* Two squares, half a side apart. */
Test(proximity_api, as_text)
{
    static const double axes[] = {1, 0, 0, 1}, here[] = {0, 0}, there[] = {1.5, 0};
    const fmb_frame f[] = {{FMB_CUBOID, 2, 2, here, axes, NULL},
                           {FMB_CUBOID, 2, 2, there, axes, NULL}};
    fmb_proximity *p = NULL;
    char text[16];
    must(fmb_distance(solver, f, FMB_NORM_EUCLIDEAN, &p, NULL));
    expect_text("1/4", fmb_proximity_measure_text(p, text, sizeof text), text);
    cr_expect_eq(fmb_proximity_length(p), 0.5);
    expect_text("-1/2", fmb_proximity_shift_text(p, 0, text, sizeof text), text);
    expect_text("0", fmb_proximity_shift_text(p, 2, text, sizeof text), text);
    expect_text("1", fmb_proximity_point_text(p, 0, 0, text, sizeof text), text);
    expect_text("3/2", fmb_proximity_point_text(p, 1, 0, text, sizeof text), text);
    expect_text("0", fmb_proximity_point_text(p, 2, 0, text, sizeof text), text);
    expect_text("0", fmb_proximity_time_text(p, text, sizeof text), text);
    expect_text("0", fmb_proximity_measure_text(NULL, text, sizeof text), text);
    cr_expect_eq(fmb_proximity_time_text(NULL, NULL, 0), 1);
    fmb_proximity_free(p);
}
