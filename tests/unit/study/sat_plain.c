/* The article's separating axes, against exact answers. */
#include <criterion/criterion.h>

#include "study/draw/pairs.h"
#include "study/rivals/sat_plain.h"

/* Pairs of whole numbers: no product of them is rounded, so that the verdict is exact, even of
 * those that just touch. */
static void agree(study_pair_family family, int dim, bool moves, uint64_t pairs)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    size_t meet = 0;
    study_pair one;
    study_pair_plan plan = {
        family, dim, moves, {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}, {0, 0}};
    o.method = FMB_PAIR_EXACT;
    cr_assert_eq(fmb_pair_new(dim, &o, NULL, &k), FMB_OK);
    for (uint64_t i = 0; i < pairs; i++) {
        fmb_verdict verdict;
        study_pair_draw(&plan, 7, i, &one);
        cr_assert_eq(fmb_pair_test(k, 1, &one.p, &one.q,
                                   &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                                       .verdict = &verdict}),
                     FMB_OK);
        cr_assert_eq(study_sat_plain(&one.p, &one.q), verdict == FMB_FEASIBLE,
                     "%s %dD, moves %d, pair %d", study_pair_family_text(family), dim, moves,
                     (int)i);
        study_sat_record record[2];
        study_sat_record_make(&one.p, &record[0]);
        study_sat_record_make(&one.q, &record[1]);
        cr_assert_eq(study_sat_program(dim, moves)(&record[0], &record[1]),
                     study_sat_plain(&one.p, &one.q));
        meet += verdict == FMB_FEASIBLE;
    }
    cr_assert(meet > pairs / 20 && meet < pairs - pairs / 20, "%zu meet", meet);
    fmb_pair_free(k);
}

Test(sat_plain, beside_exact_answers)
{
    for (int dim = 2; dim <= 3; dim++)
        for (int moves = 0; moves < 2; moves++) {
            agree(STUDY_PAIR_INTEGER, dim, moves, 400);
            agree(STUDY_PAIR_ARTICLE, dim, moves, 400);
        }
}

/* Closed sets that have one corner in common meet; open a hair's width, they do not. */
Test(sat_plain, touching)
{
    double zero[3] = {0, 0, 0}, one[3] = {1, 1, 1}, off[3] = {1, 1, 1 + 0x1p-40};
    double axes[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    fmb_frame a = {FMB_CUBOID, 3, 3, zero, axes, NULL}, b = a;
    b.origin = one;
    cr_assert(study_sat_plain(&a, &b) && study_sat_plain(&b, &a));
    b.origin = off;
    cr_assert(!study_sat_plain(&a, &b) && !study_sat_plain(&b, &a));
    a.shape = b.shape = FMB_SIMPLEX;
    b.origin = one;
    cr_assert(!study_sat_plain(&a, &b));
}
