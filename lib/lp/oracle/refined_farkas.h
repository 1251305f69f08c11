/* refined_farkas.h: proves that the multipliers of a conflict, or of an implied row, exist and have
 * the right signs, without computing them: with long numbers that is far cheaper than writing them
 * down.
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

typedef enum fmb_refined {
    FMB_REFINED_UNKNOWN = 0,
    FMB_REFINED_TRUE,
    FMB_REFINED_FALSE
} fmb_refined;

/* Is row i implied by these rows, size <= n: a combination with nonzero multipliers, positive for
 * inequalities, and no larger right side, as its relation requires? FALSE: the only combination is
 * not of this kind. Errors: MEMORY, LIMIT. */
fmb_status fmb_refined_implication(fmb_run *run, const fmb_program *p, size_t i, size_t size,
                                   const size_t *row, fmb_refined *out);

#endif
