/* floats.c: verdicts in space on records that were rounded to floats, by kernels of every width:
 * held against exact ones where rounding moves frames into and out of contact, none on numbers that
 * no float holds, and known for nearly all pairs that are not made to be near. */
#include <criterion/criterion.h>
#include <float.h>
#include <math.h>

#include "pair/kernels/packed_kernels.h"
#include "pair/packed/set.h"
#include "study/draw/pairs.h"
#include "widths.h"

enum { PAIRS = 300 };

/* ---- pairs ----------------------------------------------------------------------------------- */

typedef struct pairs {
    study_pair pair[PAIRS];
    fmb_frame p[PAIRS], q[PAIRS];
    fmb_frames *a, *b;
    fmb_packed_pairs packed;
} pairs;

static const fmb_frames_pair *number_pairs(void)
{
    static fmb_frames_pair pair[PAIRS];
    for (uint32_t i = 0; i < PAIRS; i++)
        pair[i] = (fmb_frames_pair){i, i};
    return pair;
}

/* All numbers times `scale`; as_floats: these are the frames that are meant. */
static void change_numbers(study_pair *x, double scale, bool as_floats)
{
    for (int side = 0; side < 2; side++)
        for (size_t j = 0; j < 3 * (3 + 2); j++) {
            double *number = &x->number[side][j];
            *number = scale * (as_floats ? (double)(float)*number : *number);
        }
}

/* Cuboids come first, as kernels want them. */
static void make_pairs(study_pair_family family, int shapes, bool moves, double scale,
                       bool as_floats, pairs *out)
{
    const study_pair_plan plan = {
        .family = family, .dim = 3, .moves = moves, .shape = {shapes == 2, shapes > 0}};
    const fmb_frames_pair *pair = number_pairs();
    for (int i = 0; i < PAIRS; i++) {
        study_pair_draw(&plan, 11, (uint64_t)i, &out->pair[i]);
        change_numbers(&out->pair[i], scale, as_floats);
        out->p[i] = out->pair[i].p;
        out->q[i] = out->pair[i].q;
    }
    cr_assert_eq(fmb_frames_new(3, PAIRS, out->p, NULL, &out->a), FMB_OK);
    cr_assert_eq(fmb_frames_new(3, PAIRS, out->q, NULL, &out->b), FMB_OK);
    out->packed =
        (fmb_packed_pairs){.record = {out->a->record, out->b->record},
                           .single = {out->a->single, out->b->single},
                           .index = {&pair->a, &pair->b},
                           .far = out->a->far + out->b->far,
                           .fast = out->a->fast + out->b->fast,
                           .rounding = out->a->rounded || out->b->rounded ? FMB_SINGLE_ERROR : 0,
                           .n = PAIRS,
                           .moves = moves,
                           .shapes = (fmb_packed_shapes)shapes};
    cr_expect(!as_floats || !(out->a->rounded || out->b->rounded));
}

static void free_pairs(pairs *x)
{
    fmb_frames_free(x->a);
    fmb_frames_free(x->b);
}

static void decide_exactly(const pairs *x, fmb_verdict *is)
{
    fmb_pair *k = NULL;
    fmb_pair_options o = {.size = sizeof o};
    o.method = FMB_PAIR_EXACT;
    cr_assert_eq(fmb_pair_new(3, &o, NULL, &k), FMB_OK);
    cr_assert_eq(
        fmb_pair_test(k, PAIRS, x->p, x->q,
                      &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = is}),
        FMB_OK);
    fmb_pair_free(k);
}

/* By all kernels, no verdict may be wrong; the least number of those that are known. */
static int count_known(const pairs *x, const fmb_verdict *is)
{
    const fmb_pair_kernels *kernels[WIDTHS];
    int least = PAIRS;
    for (int w = 0, n = widths(kernels); w < n; w++) {
        fmb_verdict says[PAIRS];
        int known = 0;
        bool all = kernels[w]->packed->single(&x->packed, says);
        for (int i = 0; i < PAIRS; i++) {
            cr_expect(says[i] == FMB_UNKNOWN || says[i] == is[i], "width %d, pair %d: %d", w, i,
                      says[i]);
            known += says[i] != FMB_UNKNOWN;
        }
        cr_expect_eq(all, known == PAIRS);
        least = known < least ? known : least;
    }
    return least;
}

/* ---- tests ----------------------------------------------------------------------------------- */

Test(floats, right_where_rounding_moves_frames)
{
    static const study_pair_family family[] = {
        STUDY_PAIR_ARTICLE, STUDY_PAIR_LATTICE,    STUDY_PAIR_TOUCHING, STUDY_PAIR_NEAR,
        STUDY_PAIR_FLAT,    STUDY_PAIR_DEGENERATE, STUDY_PAIR_TINY_A,   STUDY_PAIR_TINY_B,
        STUDY_PAIR_FAR,     STUDY_PAIR_SWEPT,      STUDY_PAIR_INTEGER,  STUDY_PAIR_SCALED,
        STUDY_PAIR_SPREAD,  STUDY_PAIR_RAGGED};
    static pairs x;
    fmb_verdict is[PAIRS];
    for (size_t f = 0; f < sizeof family / sizeof *family; f++)
        for (int i = 0; i < 6; i++) {
            make_pairs(family[f], i % 3, i / 3, 1, false, &x);
            decide_exactly(&x, is);
            const int known = count_known(&x, is);
            cr_expect(family[f] != STUDY_PAIR_ARTICLE || known > PAIRS * 9 / 10, "known: %d",
                      known);
            free_pairs(&x);
        }
}

/* Nothing is rounded: rounding in doubles alone leaves pairs open. */
Test(floats, floats_lose_nothing)
{
    static pairs x;
    fmb_verdict is[PAIRS];
    for (int i = 0; i < 6; i++) {
        make_pairs(STUDY_PAIR_ARTICLE, i % 3, i / 3, 0x1p-20, true, &x);
        decide_exactly(&x, is);
        cr_expect_eq(count_known(&x, is), PAIRS);
        free_pairs(&x);
    }
}

/* Too large or too small for a float, whatever else a record holds. */
Test(floats, none_where_no_float_is_near)
{
    static const double scale[] = {1e40, 1e-42, 0x1p1000, 0x1p-1000};
    static pairs x;
    fmb_verdict is[PAIRS];
    for (int i = 0; i < 6 * 4; i++) {
        make_pairs(STUDY_PAIR_ARTICLE, i % 3, i / 3 % 2, scale[i / 6], false, &x);
        decide_exactly(&x, is);
        cr_expect_eq(count_known(&x, is), 0);
        free_pairs(&x);
    }
}
