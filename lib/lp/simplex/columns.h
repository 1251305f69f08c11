/* columns.h: the rows of a scaled program by columns, for products of all rows with a vector.
 *
 * If many coefficients are nonzero, all are stored, column after column.
 */
#ifndef FMB_LP_COLUMNS_H
#define FMB_LP_COLUMNS_H

#include "lp/linalg/doubles/indexed_vector.h"
#include "lp/model/scaled_program.h"

typedef struct fmb_columns {
    const fmb_scaled_program *f;
    size_t m;        /* rows copied so far */
    bool dense;      /* then row i of column j is value[j * capacity + i] */
    size_t capacity; /* [rows] */
    size_t *start;   /* else [n + 1] where a column begins */
    int *row;
    double *value;
    size_t row_room, value_room;
} fmb_columns;

/* No rows yet. Errors: MEMORY, LIMIT. The caller must call fmb_columns_clear even then. */
fmb_status fmb_columns_init(fmb_columns *c, const fmb_scaled_program *f);
void fmb_columns_clear(fmb_columns *c);
/* Copy the rows that the scaled program got since. Errors: MEMORY, LIMIT. */
fmb_status fmb_columns_grow(fmb_columns *c);

/* rate[m] = all rows times x. */
void fmb_columns_times(const fmb_columns *c, const fmb_indexed_vector *x, fmb_indexed_vector *rate);

#endif
