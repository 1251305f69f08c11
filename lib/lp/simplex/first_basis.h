/* first_basis.h: puts equalities into the first basis without solving with the basis for each. */
#ifndef FMB_LP_FIRST_BASIS_H
#define FMB_LP_FIRST_BASIS_H

#include "lp/simplex/simplex_state.h"

/* From a basis of bounds and unit vectors, each of column j at place j, by steps of the dual method
 * to one that contains equalities, too. Errors: MEMORY, LIMIT. */
fmb_status fmb_first_basis(fmb_simplex_state *o);

#endif
