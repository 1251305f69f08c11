/* boundary.h: how far the boundary of a difference of two frames is from 0, checked.
 */
#ifndef VALIDATE_BOUNDARY_H
#define VALIDATE_BOUNDARY_H

#include "fmb-validate/difference.h"

/* Where 0 is in M: is the square of its distance from the boundary of M, times 2^-(2 unit), that?
 * If M has no interior it is all boundary. */
bool validate_depth_is(validate_difference *m, const mpq_t square);

#endif
