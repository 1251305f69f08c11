/* Separating axes in packed lanes agree with elimination on sets of frames. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/frames.h>

#include "study/draw/pairs.h"
#include "study/sat/sat.h"
#include "support/must.h"

enum { FRAMES = 75 }; /* no multiple of any number of lanes */

typedef struct duel {
    fmb_pair *way[2]; /* elimination, separating axes */
    fmb_frames *a, *b;
    study_pairs pairs;
} duel;

static duel duel_of(const study_pair_plan *plan, fmb_simd simd)
{
    duel d;
    fmb_pair_options o = {.size = sizeof o};
    o.simd = simd;
    must(fmb_pair_new(plan->dim, &o, NULL, &d.way[0]));
    must(study_sat_new(plan->dim, &o, &d.way[1]));
    must(study_pairs_make(plan, 5, FRAMES, NULL, NULL, &d.pairs));
    must(fmb_frames_new(plan->dim, FRAMES, d.pairs.p, NULL, &d.a));
    must(fmb_frames_new(plan->dim, FRAMES, d.pairs.q, NULL, &d.b));
    return d;
}

static void duel_free(duel *d)
{
    for (int i = 0; i < 2; i++)
        fmb_pair_free(d->way[i]);
    fmb_frames_free(d->a);
    fmb_frames_free(d->b);
    study_pairs_free(&d->pairs);
}

static bool count_told(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair)
{
    size_t *meet = self;
    (void)pair;
    *meet += verdict == FMB_FEASIBLE ? n : 0;
    return true;
}

static size_t count_meeting(const duel *d, int way)
{
    size_t meet = 0;
    must(fmb_frames_meet(d->way[way], d->a, d->b, count_told, &meet));
    return meet;
}

/* By rows, the same pairs by their numbers, and all against all. */
static void expect_same_verdicts(const study_pair_plan *plan, fmb_simd simd)
{
    duel d = duel_of(plan, simd);
    size_t meet = 0;
    for (uint32_t i = 0; i < FRAMES; i++) {
        fmb_frames_pair pair[FRAMES];
        fmb_verdict row[2][FRAMES], one_by_one[2][FRAMES];
        for (uint32_t j = 0; j < FRAMES; j++)
            pair[j] = (fmb_frames_pair){i, j};
        for (int w = 0; w < 2; w++) {
            const fmb_pair_answers out = {.size = sizeof out, .verdict = one_by_one[w]};
            must(fmb_frames_test_row(d.way[w], d.a, i, d.b, row[w]));
            must(fmb_frames_test(d.way[w], d.a, d.b, FRAMES, pair, &out));
            cr_assert_eq(memcmp(row[w], row[0], sizeof row[w]), 0, "row %u, way %d", i, w);
            cr_assert_eq(memcmp(one_by_one[w], row[0], sizeof row[w]), 0, "pairs of %u", i);
        }
        for (uint32_t j = 0; j < FRAMES; j++)
            meet += row[0][j] == FMB_FEASIBLE;
    }
    for (int w = 0; w < 2; w++)
        cr_expect_eq(count_meeting(&d, w), meet, "way %d: %zu", w, count_meeting(&d, w));
    cr_expect(meet > FRAMES && meet < FRAMES * FRAMES - FRAMES, "%zu of them meet", meet);
    duel_free(&d);
}

static void expect_same_in_every_case(fmb_simd simd)
{
    for (int dim = 2; dim <= 3; dim++)
        for (int moves = 0; moves < 2; moves++)
            for (int shapes = 0; shapes < 4; shapes++) {
                const study_pair_plan plan = {.dim = dim,
                                              .moves = moves,
                                              .shape = {shapes & 1, shapes >> 1},
                                              .family = STUDY_PAIR_ARTICLE};
                expect_same_verdicts(&plan, simd);
            }
}

Test(sat, says_of_sets_what_elimination_says)
{
    const fmb_simd level[] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};
    for (int i = 0; i < 3; i++)
        if (fmb_pair_kernels_choose(level[i]))
            expect_same_in_every_case(level[i]);
}
