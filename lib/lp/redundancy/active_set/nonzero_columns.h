/* nonzero_columns.h: rows in the columns that some of them name.
 *
 * Of the columns of a part, an elimination leaves few: whoever looks at all entries of a row should
 * not look at the others.
 */
#ifndef FMB_LP_NONZERO_COLUMNS_H
#define FMB_LP_NONZERO_COLUMNS_H

#include "lp/model/row.h"

typedef struct fmb_nonzero_columns {
    fmb_mem *mem;
    size_t n, m;     /* columns, rows */
    fmb_lp_row *row; /* [m] over n columns */
    fmb_vec *v;      /* [m] */
    int64_t *entry;  /* [m][n + 1] */
} fmb_nonzero_columns;

/* Rows over n columns, all of them small (num/vec.h). Errors: MEMORY, LIMIT. In any case
 * fmb_nonzero_columns_clear it. */
fmb_status fmb_nonzero_columns_open(fmb_nonzero_columns *t, fmb_mem *mem, size_t n, size_t m,
                                    const fmb_lp_row *row);
void fmb_nonzero_columns_clear(fmb_nonzero_columns *t);

#endif
