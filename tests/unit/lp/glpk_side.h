/* glpk_side.h: GLPK as a side of the door of its own, so that what it hands out is tested as ours
 * is. It starts from unit vectors each time; the door is not to be had where GLPK is not installed.
 */
#ifndef TESTS_LP_GLPK_SIDE_H
#define TESTS_LP_GLPK_SIDE_H

#include "lp/float/side.h"

extern const fmb_door_side glpk_side;

#endif
