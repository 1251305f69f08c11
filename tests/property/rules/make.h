/* make.h: random systems that give pruning rules something to do. */
#ifndef FMB_TEST_MAKE_H
#define FMB_TEST_MAKE_H

#include <fmb/system.h>

/* Up to 6 variables and 14 rows, from the seed alone; the caller frees it. Rows through a common
 * point, planted conflicts, cones, and rows without a plan; -1..1, small numbers, and numbers near
 * 2^31 and 2^62; copies, multiples and parallels of other rows; rows with one variable; strict rows
 * and equalities in a share of the systems. */
fmb_system *make_system(uint64_t seed);

#endif
