/* refined_farkas.h: is there a conflict? Whether its multipliers exist and have the right signs,
 * without solving for them: where numbers are long, that takes far less than writing them down.
 */
#ifndef FMB_LP_REFINED_FARKAS_H
#define FMB_LP_REFINED_FARKAS_H

#include "lp/oracle/vertex.h"

/* Are the rows of the basis long numbers, and few enough for this? */
bool fmb_refined_farkas_is_worth_it(const fmb_vertex *v);

/* Does the basis contradict row `odd`, times *sign? *sure: it does, that is, prices y exist such
 * that sign a_odd - sum_r y_r a_r = 0 and so on as fmb_pivot_walk_try_conflict has it. Not sure:
 * nothing is said. Errors: MEMORY, LIMIT. */
fmb_status fmb_refined_farkas(const fmb_vertex *v, size_t odd, int *sign, bool *sure);

#endif
