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
    size_t *touched; /* the same, and [rows], which are in it */
    bool *is_touched;
} fmb_claimed_rows;

/* The last claims of q are those of the image, in the order of its rows; place[dim] is the column
 * of each variable, -1 of those that went. In any case close it. Errors: MEMORY, LIMIT. */
fmb_status fmb_claimed_rows_open(fmb_claimed_rows *c, fmb_query *q, const int *place,
                                 fmb_system *image);
void fmb_claimed_rows_close(fmb_claimed_rows *c);

/* Append the row z[0..n).x REL z[n], n columns. It is the sum of w, multipliers of rows of the
 * image: negative for none but equations; w is not looked at where no claims are wanted. Errors:
 * MEMORY, LIMIT: nothing was appended. */
fmb_status fmb_claimed_rows_append(fmb_claimed_rows *c, mpz_t *z, fmb_rel rel,
                                   const fmb_weights *w);
/* The last row takes the place of row i, which goes. */
void fmb_claimed_rows_put_last(fmb_claimed_rows *c, size_t i);
/* Row i goes, those behind it move up. */
void fmb_claimed_rows_drop(fmb_claimed_rows *c, size_t i);
/* Rows and claims in the order of fmb_sysrow_compare. Errors: MEMORY, LIMIT: the order is what it
 * was. */
fmb_status fmb_claimed_rows_sort(fmb_claimed_rows *c);

#endif
