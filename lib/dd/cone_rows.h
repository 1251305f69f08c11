/* cone_rows.h: rows of a cone, written one by one into an arena. */
#ifndef FMB_DD_CONE_ROWS_H
#define FMB_DD_CONE_ROWS_H

#include "dd/cone.h"

typedef struct fmb_cone_rows {
    size_t d, size;
    fmb_cone_row *row; /* [size] */
    fmb_vec *v;        /* [size] */
} fmb_cone_rows;

/* Write row i of what `of` points to: z[d], which holds anything, and what kind of row it is. */
typedef void fmb_cone_row_writer(const void *of, size_t i, mpz_t *z, fmb_cone_row *row);

/* So many rows of d numbers. Errors: MEMORY, LIMIT. In any case fmb_cone_rows_clear them, before
 * the arena goes. */
fmb_status fmb_cone_rows_write(fmb_cone_rows *r, fmb_arena *arena, fmb_run *run, size_t d,
                               size_t size, fmb_cone_row_writer *write, const void *of);
void fmb_cone_rows_clear(fmb_cone_rows *r, fmb_mem *mem);

#endif
