/* row.h: a row of a linear program as given by the caller. */
#ifndef FMB_LP_ROW_H
#define FMB_LP_ROW_H

#include "num/vec.h"

typedef struct fmb_lp_row {
    const fmb_vec *v; /* [n + 1] coefficients and right side */
    fmb_rel rel;
} fmb_lp_row;

/* Are all numbers of the rows small (num/vec.h)? */
static inline bool fmb_lp_rows_are_small(size_t m, const fmb_lp_row *row)
{
    for (size_t i = 0; i < m; i++)
        if (row[i].v->z)
            return false;
    return true;
}

#endif
