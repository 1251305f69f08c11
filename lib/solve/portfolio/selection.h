/* selection.h: which ways of a projection are tried, and for how long, by what a part is like.
 *
 * Nothing is measured but numbers of rows, variables and coefficients, so that the same system
 * takes the same way everywhere. The limits below were found on families of systems
 * (study/program), and hold on seeds that they were not found on.
 */
#ifndef FMB_SOLVE_SELECTION_H
#define FMB_SOLVE_SELECTION_H

#include "solve/portfolio/features.h"

/* A few rows are eliminated faster than anything else is done. */
#define FMB_TRIAL_BUDGET(m) (128 + 4 * (m))
/* In so many, queries are few, and rays soon turned into facets. */
#define FMB_SHORT_QUERIES 4

/* May a direction among the variables that go leave all rows behind? */
bool fmb_selection_tries_recession(const fmb_features *f);
/* Two questions to the oracle are all there is to do. */
bool fmb_selection_asks_ends(const fmb_features *f);
/* Is it asked first whether there is a solution? */
bool fmb_selection_doubts_solution(const fmb_features *f);
/* Are variables eliminated that make few more rows than go? */
bool fmb_selection_bounds_growth(const fmb_features *f);
/* Rows that an elimination may make that is pruned before anything else is done; 0: none is tried.
 */
size_t fmb_selection_pruned_rows(const fmb_features *f);
bool fmb_selection_raises_bound(const fmb_features *f);
/* Rays of a first try, and of a second one, before queries. */
uint64_t fmb_selection_first_rays(const fmb_features *f);
uint64_t fmb_selection_second_rays(const fmb_features *f);
/* Are the rows that an elimination left few enough to go on with? There were so many before. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept);

#endif
