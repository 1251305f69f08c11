/* claimed_rows.h: the rows of a projection, each with its claim, as one list.
 *
 * Invariant: claim first + i says that row i of the image is implied, where claims are wanted.
 */
#ifndef FMB_SOLVE_CLAIMED_ROWS_H
#define FMB_SOLVE_CLAIMED_ROWS_H

#include "solve/query/solver.h"
#include "system/system_private.h"

typedef struct fmb_claimed_rows {
    fmb_query *q;
    fmb_system *image;
    int *variable;   /* [n] of the query's system, by column of the image */
    size_t first;    /* claim of row 0 */
    mpq_t *sum;      /* [rows of the query's system] scratch, zeros; NULL without claims */
    size_t *touched; /* [rows] indices of the entries of sum in use; NULL without claims */
    bool *is_touched;
} fmb_claimed_rows;

/* The last claims of q are those of the image, in the order of its rows; place[dim]: the column of
 * a variable, -1 if eliminated. Close it, even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_claimed_rows_open(fmb_claimed_rows *c, fmb_query *q, const int *place,
                                 fmb_system *image);
void fmb_claimed_rows_close(fmb_claimed_rows *c);

/* Append the row z[0..n).x REL z[n], n columns. It is the combination of rows of the image with the
 * multipliers w, negative only for equations; w is ignored where no claims are wanted. Errors:
 * MEMORY, LIMIT; then nothing was appended. */
fmb_status fmb_claimed_rows_append(fmb_claimed_rows *c, mpz_t *z, fmb_rel rel,
                                   const fmb_weights *w);
/* Replace row i by the last row. */
void fmb_claimed_rows_put_last(fmb_claimed_rows *c, size_t i);
/* Remove row i; later rows move up. */
void fmb_claimed_rows_drop(fmb_claimed_rows *c, size_t i);
/* Sort rows and claims by fmb_sysrow_compare. Errors: MEMORY, LIMIT; then the order is unchanged.
 */
fmb_status fmb_claimed_rows_sort(fmb_claimed_rows *c);

#endif
