/* preimages.h: the functions of fmb/lift.h for tests: their results are checked before they are
 * returned. */
#ifndef FMB_TEST_PREIMAGES_H
#define FMB_TEST_PREIMAGES_H

#include <fmb/lift.h>

typedef struct lifts_answer {
    fmb_system *lift, *out;
    fmb_verdict verdict;
} lifts_answer;

/* One that keeps all evidence. */
fmb_solver *lifts_solver(void);

/* [give, lifts_clear] The evidence was accepted as one about the lift. */
lifts_answer lifts_image(fmb_solver *v, const fmb_system *s, const fmb_system *graph);
lifts_answer lifts_sum(fmb_solver *v, const fmb_system *const *s, size_t n);
lifts_answer lifts_hull(fmb_solver *v, const fmb_system *const *s, size_t n);
void lifts_clear(lifts_answer *a);

#endif
