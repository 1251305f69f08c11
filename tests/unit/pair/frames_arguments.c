/* frames_arguments.c: refused sets of frames, and refused questions about them. */
#include <criterion/criterion.h>
#include <math.h>

#include <fmb/frames.h>

#include "property/random/rows.h"

Test(frames, arguments)
{
    const double zero[3] = {0}, bad[3] = {0, NAN, 0};
    fmb_frame f[2] = {{FMB_SIMPLEX, 3, 0, zero, NULL, NULL}, {FMB_SIMPLEX, 3, 0, bad, NULL, NULL}};
    fmb_frames *set = NULL, *flat = NULL;
    cr_expect_eq(fmb_frames_new(3, 2, f, NULL, &set), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_new(2, 1, f, NULL, &set), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_new(0, 0, f, NULL, &set), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_new(3, 1, NULL, NULL, &set), FMB_ERR_ARG);
    fmb_frame_arrays arrays = {.size = sizeof arrays, .naxes = 1, .origin = zero};
    cr_expect_eq(fmb_frames_from_arrays(3, 1, &arrays, NULL, &set), FMB_ERR_ARG);
    arrays.axes = bad;
    cr_expect_eq(fmb_frames_from_arrays(3, 1, &arrays, NULL, &set), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_from_arrays(3, 1, NULL, NULL, &set), FMB_ERR_ARG);
    cr_assert_null(set);
    must(fmb_frames_new(3, 1, f, NULL, &set));
    must(fmb_frames_new(2, 0, NULL, NULL, &flat));
    fmb_pair *k = NULL;
    must(fmb_pair_new(3, NULL, NULL, &k));
    fmb_verdict v[2] = {FMB_UNKNOWN};
    const fmb_pair_answers out = {.size = sizeof out, .verdict = v};
    const fmb_frames_pair pair[2] = {{0, 0}, {0, 1}};
    cr_expect_eq(fmb_frames_test(NULL, set, set, 1, pair, &out), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_test(k, set, flat, 0, pair, &out), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_test(k, set, NULL, 1, pair, &out), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_test(k, set, set, 1, NULL, &out), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_pair_trouble(k), "pair is NULL");
    cr_expect_eq(fmb_frames_test(k, set, set, 2, pair, &out), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_pair_trouble(k), "pair[1]: no such frame");
    cr_expect_eq(fmb_frames_test_row(k, set, 1, set, v), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_test_row(k, set, 0, set, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_meet(k, set, set, NULL, NULL), FMB_ERR_ARG);
    must(fmb_frames_test(k, set, set, 1, pair, &out));
    cr_expect_eq(v[0], FMB_FEASIBLE); /* a point meets itself */
    fmb_pair_free(k);
    fmb_frames_free(set);
    fmb_frames_free(flat);
}
