/* first_basis.h: equalities that come into the first basis without a solution for each. */
#ifndef FMB_LP_FIRST_BASIS_H
#define FMB_LP_FIRST_BASIS_H

#include "lp/simplex/simplex_state.h"

/* From a basis of bounds and unit vectors, that of column j at place j, by steps of the dual method
 * to one that has equalities, too. Errors: MEMORY, LIMIT. */
fmb_status fmb_first_basis(fmb_simplex_state *o);

#endif
