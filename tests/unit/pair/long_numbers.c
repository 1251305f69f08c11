/* long_numbers.c: limits and cancels end queries about frames whose numbers differ as much as
 * doubles can: after the clock reading at which the time is up at most two more follow. */
#include <criterion/criterion.h>

#include "counted_clock.h"
#include "property/random/rows.h"
#include "study/draw/pairs.h"
#include "support/pair_counts.h"

enum { DIM = 4, PAIRS = 60, MOST_READINGS = 5 };

static fmb_pair *new_pair(double max_seconds)
{
    fmb_pair_options o = {.size = sizeof o, .tightest = true, .max_seconds = max_seconds};
    fmb_pair *k = NULL;
    must(fmb_pair_new(DIM, &o, NULL, &k));
    return k;
}

/* Moving frames number i, which share more than doubles tell. */
static void draw_pair(int i, study_pair *out)
{
    study_pair_plan plan = {.family = STUDY_PAIR_RAGGED,
                            .dim = DIM,
                            .moves = true,
                            .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
    study_pair_draw(&plan, 5, (uint64_t)i, out);
}

static fmb_verdict find_box(fmb_pair *k, const study_pair *x, double *world)
{
    fmb_verdict said = FMB_UNKNOWN;
    fmb_pair_answers out = {.size = sizeof out, .verdict = &said, .world = world};
    must(fmb_pair_test(k, 1, &x->p, &x->q, &out));
    return said;
}

static void cancel(void *k)
{
    fmb_pair_cancel(k);
}

/* Of pair x, within so many readings; a cancel at one of them, 0: none. UNKNOWN, or the same box.
 */
static bool is_cut_short(const study_pair *x, const double *whole, size_t seconds, size_t at)
{
    double world[2 * DIM];
    fmb_pair *k = new_pair(seconds > 0 ? (double)seconds : COUNTED_FOREVER);
    counted_clock_start(at, cancel, k);
    fmb_verdict said = find_box(k, x, world);
    counted_clock_stop();
    fmb_pair_free(k);
    cr_assert_neq(said, FMB_INFEASIBLE);
    cr_expect_leq(counted_clock_readings(), said == FMB_UNKNOWN ? seconds + at + 2 : 1000);
    for (int i = 0; said == FMB_FEASIBLE && i < 2 * DIM; i++)
        cr_expect(world[i] >= whole[i] && world[i] <= whole[i], "end %d: %a, not %a", i, world[i],
                  whole[i]);
    return said == FMB_UNKNOWN;
}

Test(long_numbers, limits_and_cancels)
{
    int met = 0, cut = 0, cancelled = 0;
    for (int i = 0; i < PAIRS; i++) {
        study_pair x;
        double whole[2 * DIM];
        fmb_pair *k = new_pair(0);
        draw_pair(i, &x);
        fmb_verdict said = find_box(k, &x, whole);
        cr_assert_neq(said, FMB_UNKNOWN);
        cr_expect_eq(counts_of_pairs(k).exact_boxes, 0u, "pair %d is asked of the solver", i);
        fmb_pair_free(k);
        met += said == FMB_FEASIBLE;
        for (size_t n = 1; said == FMB_FEASIBLE && n <= MOST_READINGS; n++) {
            cut += is_cut_short(&x, whole, n, 0);
            cancelled += is_cut_short(&x, whole, 0, n);
        }
    }
    cr_expect(met > 5 && cut > met && cancelled > met, "%d meet, %d cut, %d cancelled", met, cut,
              cancelled);
}
