/* row.h: a row of a linear program as given by the caller. */
#ifndef FMB_LP_ROW_H
#define FMB_LP_ROW_H

#include "num/vec.h"

typedef struct fmb_lp_row {
    const fmb_vec *v; /* [n + 1] coefficients and right side */
    fmb_rel rel;
} fmb_lp_row;

#endif
