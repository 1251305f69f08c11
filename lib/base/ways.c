/* ways.c: the switches and counts of a build that has them; see ways.h. */
#include "base/ways.h"

#ifdef FMB_ABLATE
static fmb_ways all_on;
fmb_ways *fmb_ways_at_hand = &all_on;
#else
typedef int fmb_ways_are_all_on; /* C forbids empty files */
#endif
