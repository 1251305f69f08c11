/* columns.h: the rows of a scaled program, by columns: what all rows say of a vector.
 *
 * Where many coefficients are not zero, all are kept, column after column.
 */
#ifndef FMB_LP_COLUMNS_H
#define FMB_LP_COLUMNS_H

#include "lp/linalg/doubles/indexed_vector.h"
#include "lp/model/scaled_program.h"

typedef struct fmb_columns {
    const fmb_scaled_program *f;
    size_t m;        /* rows taken in */
    bool dense;      /* then row i of column j is value[j * capacity + i] */
    size_t capacity; /* [rows] */
    size_t *start;   /* else [n + 1] where a column begins */
    int *row;
    double *value;
    size_t row_room, value_room;
} fmb_columns;

/* No rows yet. In any case fmb_columns_clear it. Errors: MEMORY, LIMIT. */
fmb_status fmb_columns_init(fmb_columns *c, const fmb_scaled_program *f);
void fmb_columns_clear(fmb_columns *c);
/* Take in the rows that the scaled program has by now. Errors: MEMORY, LIMIT. */
fmb_status fmb_columns_grow(fmb_columns *c);

/* rate = all rows times x; rate is of m places. */
void fmb_columns_times(const fmb_columns *c, const fmb_indexed_vector *x, fmb_indexed_vector *rate);

#endif
