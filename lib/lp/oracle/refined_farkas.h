/* refined_farkas.h: proves that the multipliers of a conflict exist and have the right signs,
 * without computing them: with long numbers that is far cheaper than writing them down.
 */
#ifndef FMB_LP_REFINED_FARKAS_H
#define FMB_LP_REFINED_FARKAS_H

#include "lp/oracle/vertex.h"

/* Are the rows of the basis long numbers, and few enough for this method? */
bool fmb_refined_farkas_is_worth_it(const fmb_vertex *v);

/* Does the basis contradict row `odd`, times *sign? *sure: yes, that is, there are prices y with
 * sign a_odd - sum_r y_r a_r = 0 and the signs of fmb_pivot_walk_try_conflict. Not *sure: nothing
 * is known. Errors: MEMORY, LIMIT. */
fmb_status fmb_refined_farkas(const fmb_vertex *v, size_t odd, int *sign, bool *sure);

#endif
