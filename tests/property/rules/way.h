/* way.h: random options around a mix of rules. */
#ifndef FMB_TEST_WAY_H
#define FMB_TEST_WAY_H

#include <fmb/options.h>

#include "support.h"

/* Elimination alone decides, with this mix of rules, under limits of rows and bytes. Order,
 * arithmetic and instructions are random; histories start anew mostly at once, and half of the time
 * there is no presolve, so that little is settled before the rules come in. */
fmb_options way_at(support_rng *g, unsigned mix);

/* The widest of the levels of instructions that this library accepts here. */
fmb_simd way_widest(void);

#endif
