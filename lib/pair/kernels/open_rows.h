/* open_rows.h: of two cuboids in four to eight dimensions, the rows (minors/minors_kernel.h) that
 * doubles leave open, decided in whole numbers.
 *
 * A row is a direction n that is perpendicular to D - 1 vectors: edges of A and of B, and maybe the
 * drift. It keeps the two apart iff the gap
 *
 *     |n (2 shift + edges of B + drift - edges of A)| - sum over all edges e of both of |n e|
 *         - |n drift|
 *
 * is positive. If all other rows are certainly negative, then closed cuboids meet iff none of these
 * is positive, and their interiors meet iff all are negative; rows whose n is 0 say nothing.
 */
#ifndef FMB_PAIR_KERNELS_OPEN_ROWS_H
#define FMB_PAIR_KERNELS_OPEN_ROWS_H

#include <stdbool.h>
#include <stdint.h>

#include <fmb/frame.h>

typedef struct fmb_open_row {
    uint32_t vectors; /* bits: edges of A, those of B, the drift */
    bool from_b;      /* those of B change less often from one row to the next */
    uint8_t lanes;    /* where the row is open */
} fmb_open_row;

enum { FMB_OPEN_ROWS_MOST = 512 };

/* Of pairs side by side. Number r of a record (minors_kernels.h) of pair l is record[..][r * width
 * + l]. */
typedef struct fmb_open_rows {
    int dim, width;
    bool moves, closed;
    const double *record[2];
    unsigned wanted, full; /* lanes that are asked; those with more rows than there is room for */
    int n;
    fmb_open_row row[FMB_OPEN_ROWS_MOST];
} fmb_open_rows;

/* How many words the numbers of a pair need, 1 or 2; 0: too many. No rows are wanted for that. */
int fmb_open_rows_words(const fmb_open_rows *x, unsigned l);

/* With so many words, 1 or 2. UNKNOWN: there are too many rows. */
fmb_verdict fmb_open_rows_decide(const fmb_open_rows *x, unsigned l, int words);

#endif
