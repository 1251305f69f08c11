/* open_rows.h: of cuboids and simplices in four to eight dimensions, the rows
 * (minors/minors_kernel.h) that doubles leave open, decided in whole numbers.
 *
 * A row is a direction n that is perpendicular to D - 1 vectors: to a face of A, to one of B, and
 * maybe to the drift. Where A and B, at all its places from t = 0 to 1, have no number in common
 * along n they are apart. If all other rows are certainly negative (their numbers overlap by more
 * than nothing), then closed frames meet iff none of these is positive, and their interiors meet
 * iff all are negative; rows whose n is 0 say nothing.
 */
#ifndef FMB_PAIR_KERNELS_OPEN_ROWS_H
#define FMB_PAIR_KERNELS_OPEN_ROWS_H

#include <stdbool.h>
#include <stdint.h>

#include <fmb/frame.h>

#include "pair/kernels/whole_pair.h"

/* The vectors of a face: a bit for each edge of a cuboid, and the one behind these for the drift of
 * B; of a simplex the corners of a face, the origin first. */
typedef struct fmb_open_row {
    uint16_t face[2];
    bool from_b;   /* that of B changes less often from one row to the next */
    uint8_t lanes; /* where the row is open */
} fmb_open_row;

enum { FMB_OPEN_ROWS_MOST = 512 };

/* Of one of each A is the simplex. */
typedef struct fmb_open_rows {
    whole_records of;
    bool closed;
    bool all;        /* all open rows are in the list; else one of each lane, if there is any */
    unsigned wanted; /* lanes whose rows go to the list */
    unsigned full;   /* those with more rows than there is room for */
    int n;
    fmb_open_row row[FMB_OPEN_ROWS_MOST];
} fmb_open_rows;

/* Are the numbers of a pair short enough? No rows are wanted where they are not. */
bool fmb_open_rows_are_short(const fmb_open_rows *x, unsigned l);

/* UNKNOWN: there are too many rows, or too few, or numbers are too long for them. */
fmb_verdict fmb_open_rows_decide(const fmb_open_rows *x, unsigned l);

#endif
