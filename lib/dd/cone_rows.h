/* cone_rows.h: the rows of a cone, written one by one into an arena. */
#ifndef FMB_DD_CONE_ROWS_H
#define FMB_DD_CONE_ROWS_H

#include "dd/cone.h"

typedef struct fmb_cone_rows {
    size_t d, size;
    fmb_cone_row *row; /* [size] */
    fmb_vec *v;        /* [size] */
} fmb_cone_rows;

/* Write row i of `of`: its entries to z[d], whose old values are arbitrary; its kind to *row. */
typedef void fmb_cone_row_writer(const void *of, size_t i, mpz_t *z, fmb_cone_row *row);

/* `size` rows of d entries. Errors: MEMORY, LIMIT. The caller must call fmb_cone_rows_clear even
 * after an error, before the arena is cleared. */
fmb_status fmb_cone_rows_write(fmb_cone_rows *r, fmb_arena *arena, fmb_run *run, size_t d,
                               size_t size, fmb_cone_row_writer *write, const void *of);
void fmb_cone_rows_clear(fmb_cone_rows *r, fmb_mem *mem);

#endif
