/* wrong.h: a system on which a way goes wrong, made smaller. */
#ifndef FMB_STUDY_WRONG_H
#define FMB_STUDY_WRONG_H

#include "study/grid/grid.h"

/* [give, fmb_system_free] The system of a case without rows that the way goes wrong without: with
 * any one row less it answers rightly. NULL where it does not go wrong. */
fmb_status study_smallest_wrong(const study_case *c, const study_way *way,
                                const study_limits *limits, fmb_system **out);

#endif
