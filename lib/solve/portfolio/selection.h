/* selection.h: which ways of a projection are tried, and for how long, by what a part is like.
 *
 * Nothing is measured but numbers of rows, variables and coefficients, so that the same system
 * takes the same way everywhere. The limits below were found on families of systems
 * (study/program), and hold on seeds that they were not found on.
 */
#ifndef FMB_SOLVE_SELECTION_H
#define FMB_SOLVE_SELECTION_H

#include "solve/portfolio/project_rays.h"

/* A few rows are eliminated faster than anything else is done. */
#define FMB_TRIAL_BUDGET(m) (128 + 4 * (m))
/* In so many, queries are few, and rays soon turned into facets. */
#define FMB_SHORT_QUERIES 4

int fmb_judge_kept(const fmb_part *p, const int *place);
/* Is it gone around, in the plane? */
bool fmb_judge_walks(const fmb_lift *lift, const fmb_part *p, int kept);
/* May a direction among the variables that go leave all rows behind? */
bool fmb_judge_escapes(const fmb_lift *lift);
/* Two questions to the oracle are all there is to do. */
bool fmb_judge_asks_ends(const fmb_lift *lift, const fmb_part *p, int kept);
/* Is it asked first whether there is a solution? */
bool fmb_judge_doubts_solution(const fmb_lift *lift);
/* Are variables eliminated that make few more rows than go? */
bool fmb_judge_goes_gently(const fmb_lift *lift, int kept);
/* Rows that an elimination may make that is pruned before anything else is done; 0: none is tried.
 */
size_t fmb_judge_pruned_rows(const fmb_lift *lift, const fmb_part *p, int kept);
bool fmb_judge_goes_steeper(const fmb_lift *lift, int kept);
/* Rays of a first try, and of a second one, before queries. */
uint64_t fmb_judge_first_rays(const fmb_lift *lift, const fmb_part *p, int kept);
uint64_t fmb_judge_second_rays(const fmb_lift *lift, const fmb_part *p, int kept);
/* Are the rows that an elimination left few enough to go on with? There were so many before. */
bool fmb_judge_thins(const fmb_elim *e, size_t before, int kept);

#endif
