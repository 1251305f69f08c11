/* wrong.h: a minimal system on which a way answers wrongly. */
#ifndef FMB_STUDY_WRONG_H
#define FMB_STUDY_WRONG_H

#include "study/grid/grid.h"

/* [give, fmb_system_free] The system of a case, reduced by rows while the way still answers
 * wrongly: without any one of the remaining rows it answers rightly. NULL if none is wrong. */
fmb_status study_smallest_wrong(const study_case *c, const study_way *way,
                                const study_limits *limits, fmb_system **out);

#endif
