/* null_members.c: NULL for each array inside the structures that public functions take: ARG, and
 * nothing is read or written through it. NULL for their own pointers: nulls.c. */
#include <criterion/criterion.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>
#include <fmb/gmp.h>

#include "support/must.h"

static double origin[1] = {0}, axes[1] = {1};

/* Two cuboids in one dimension, of which one lacks an array: four ways. */
enum { LACKS = 4 };

static void make_frames(fmb_frame f[2], int lack)
{
    for (int i = 0; i < 2; i++)
        f[i] = (fmb_frame){FMB_CUBOID, 1, 1, origin, axes, NULL};
    if (lack % 2 == 0)
        f[lack / 2].origin = NULL;
    else
        f[lack / 2].axes = NULL;
}

static void make_rationals(fmb_frame_q f[2], mpq_t *a, int lack)
{
    for (int i = 0; i < 2; i++)
        f[i] = (fmb_frame_q){FMB_CUBOID, 1, 1, a, a + 1, NULL};
    if (lack % 2 == 0)
        f[lack / 2].origin = NULL;
    else
        f[lack / 2].axes = NULL;
}

static fmb_system *row_over_a_line(void)
{
    fmb_system *s = NULL;
    must(fmb_system_new(1, NULL, &s));
    must(fmb_system_add_int(s, (int64_t[]){1}, FMB_LE, 1));
    return s;
}

/* ---- frames ---------------------------------------------------------------------------------- */

Test(null_members, frames_as_systems_and_sets)
{
    for (int lack = 0; lack < LACKS; lack++) {
        fmb_frame f[2];
        fmb_system *s = NULL;
        fmb_frames *set = NULL;
        char bytes[256];
        size_t length;
        make_frames(f, lack);
        cr_expect_eq(
            fmb_system_from_frames(f, 2, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, &s),
            FMB_ERR_ARG);
        cr_expect_eq(fmb_frames_new(1, 2, f, NULL, &set), FMB_ERR_ARG);
        cr_expect_eq(fmb_frame_pairs_print(1, &f[0], &f[1], bytes, sizeof bytes, &length),
                     FMB_ERR_ARG);
        cr_expect(!s && !set);
    }
}

Test(null_members, frames_of_pairs)
{
    fmb_pair *k = NULL;
    must(fmb_pair_new(1, NULL, NULL, &k));
    for (int lack = 0; lack < LACKS; lack++) {
        fmb_frame f[2];
        fmb_verdict verdict;
        const fmb_pair_answers answers = {.size = sizeof answers, .verdict = &verdict};
        make_frames(f, lack);
        cr_expect_eq(fmb_pair_test(k, 1, &f[0], &f[1], &answers), FMB_ERR_ARG);
        cr_expect_str_not_empty(fmb_pair_trouble(k));
    }
    fmb_pair_free(k);
}

Test(null_members, frames_nearby)
{
    fmb_system *row = row_over_a_line();
    fmb_solver *v = NULL;
    must(fmb_solver_new(NULL, NULL, &v));
    for (int lack = 0; lack < LACKS; lack++) {
        fmb_frame f[2];
        fmb_proximity *near = NULL;
        fmb_system *s = NULL;
        fmb_generators *g = NULL;
        make_frames(f, lack);
        cr_expect_eq(fmb_distance(v, f, FMB_NORM_MAX, &near, NULL), FMB_ERR_ARG);
        cr_expect_eq(fmb_depth(v, f, FMB_NORM_MAX, &near, NULL), FMB_ERR_ARG);
        cr_expect_eq(fmb_separate(v, f, FMB_CONTACT_CLOSED, &s, NULL), FMB_ERR_ARG);
        cr_expect_eq(fmb_common(v, f, &g, NULL), FMB_ERR_ARG);
        cr_expect_not(fmb_separates(f, FMB_CONTACT_CLOSED, row));
        cr_expect(!near && !s && !g);
    }
    fmb_solver_free(v);
    fmb_system_free(row);
}

Test(null_members, rational_frames)
{
    fmb_system *row = row_over_a_line();
    fmb_solver *v = NULL;
    mpq_t a[2];
    mpq_inits(a[0], a[1], NULL);
    mpq_set_ui(a[1], 1, 1);
    must(fmb_solver_new(NULL, NULL, &v));
    for (int lack = 0; lack < LACKS; lack++) {
        fmb_frame_q f[2];
        fmb_proximity *near = NULL;
        fmb_system *s = NULL;
        fmb_generators *g = NULL;
        make_rationals(f, a, lack);
        cr_expect_eq(
            fmb_system_from_frames_q(f, 2, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, &s),
            FMB_ERR_ARG);
        cr_expect_eq(fmb_distance_q(v, f, FMB_NORM_MAX, &near, NULL), FMB_ERR_ARG);
        cr_expect_eq(fmb_depth_q(v, f, FMB_NORM_MAX, &near, NULL), FMB_ERR_ARG);
        cr_expect_eq(fmb_separate_q(v, f, FMB_CONTACT_CLOSED, &s, NULL), FMB_ERR_ARG);
        cr_expect_eq(fmb_common_q(v, f, &g, NULL), FMB_ERR_ARG);
        cr_expect_not(fmb_separates_q(f, FMB_CONTACT_CLOSED, row));
        cr_expect(!near && !s && !g);
    }
    fmb_solver_free(v);
    fmb_system_free(row);
    mpq_clears(a[0], a[1], NULL);
}

/* ---- arrays of frames, answers, objectives --------------------------------------------------- */

Test(null_members, arrays_and_answers)
{
    fmb_frame_arrays arrays = {.size = sizeof arrays, .naxes = 1, .origin = origin};
    fmb_frames *set = NULL;
    fmb_pair *k = NULL;
    fmb_frame f[2] = {{FMB_CUBOID, 1, 1, origin, axes, NULL},
                      {FMB_CUBOID, 1, 1, origin, axes, NULL}};
    const fmb_frames_pair both = {0, 0};
    const fmb_pair_answers none = {.size = sizeof none};
    cr_expect_eq(fmb_frames_from_arrays(1, 1, &arrays, NULL, &set), FMB_ERR_ARG);
    arrays = (fmb_frame_arrays){.size = sizeof arrays, .naxes = 1, .axes = axes};
    cr_expect_eq(fmb_frames_from_arrays(1, 1, &arrays, NULL, &set), FMB_ERR_ARG);
    cr_assert_null(set);
    must(fmb_frames_new(1, 2, f, NULL, &set));
    must(fmb_pair_new(1, NULL, NULL, &k));
    cr_expect_eq(fmb_pair_test(k, 1, &f[0], &f[1], &none), FMB_ERR_ARG);
    cr_expect_eq(fmb_frames_test(k, set, set, 1, &both, &none), FMB_ERR_ARG);
    fmb_pair_free(k);
    fmb_frames_free(set);
}

Test(null_members, objectives)
{
    const fmb_objective best = {.sense = FMB_SENSE_MAX};
    fmb_objective_q exact = {.sense = FMB_SENSE_MAX, .n = 1, .var = (int[]){0}};
    fmb_system *s = row_over_a_line();
    fmb_solver *v = NULL;
    fmb_optimum *got = NULL;
    mpq_t one[1];
    mpq_init(one[0]);
    mpq_set_ui(one[0], 1, 1);
    must(fmb_solver_new(NULL, NULL, &v));
    cr_expect_eq(fmb_system_set_objective(s, &best), FMB_ERR_ARG);
    cr_expect_eq(fmb_optimize(v, s, &best, &got, NULL), FMB_ERR_ARG);
    for (int lack = 0; lack < 2; lack++) {
        cr_expect_eq(fmb_system_set_objective_q(s, &exact), FMB_ERR_ARG);
        cr_expect_eq(fmb_optimize_q(v, s, &exact, &got, NULL), FMB_ERR_ARG);
        exact = (fmb_objective_q){.sense = FMB_SENSE_MAX, .n = 1, .coef = one};
    }
    cr_expect_null(got);
    fmb_solver_free(v);
    fmb_system_free(s);
    mpq_clear(one[0]);
}
