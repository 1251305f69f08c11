/* open_rows.h: rows (minors/minors_kernel.h) of cuboids and simplices in four to eight dimensions
 * that doubles leave open, decided in integers.
 *
 * A row is a direction n perpendicular to D - 1 vectors: of a face of A, of a face of B, and maybe
 * the drift. If the intervals of A and of B, swept from t = 0 to 1, along n are disjoint, the row
 * is positive and the frames are apart; if they overlap in more than a point, it is negative. If
 * all other rows are certainly negative, closed frames meet iff none of the open rows is positive,
 * and interiors meet iff all are negative; rows with n = 0 are ignored.
 */
#ifndef FMB_PAIR_KERNELS_OPEN_ROWS_H
#define FMB_PAIR_KERNELS_OPEN_ROWS_H

#include <stdbool.h>
#include <stdint.h>

#include <fmb/frame.h>

#include "pair/kernels/whole_pair.h"

/* The vectors of a face: a bit for each edge of a cuboid, and the next one for the drift of B; for
 * a simplex a bit for each corner of the face, the origin first. */
typedef struct fmb_open_row {
    uint16_t face[2];
    bool from_b;   /* the face of B changes less often from row to row */
    uint8_t lanes; /* bits of lanes where the row is open */
} fmb_open_row;

enum { FMB_OPEN_ROWS_MOST = 512 };

/* If one frame is a simplex and the other a cuboid, A is the simplex. */
typedef struct fmb_open_rows {
    whole_records of;
    bool closed;
    bool all;        /* all open rows are in the list; else at most one of each lane */
    unsigned wanted; /* lanes whose rows are listed */
    unsigned full;   /* lanes with more rows than there is room for */
    int n;
    fmb_open_row row[FMB_OPEN_ROWS_MOST];
} fmb_open_rows;

/* Are the numbers of a pair short enough? Otherwise its rows are not listed. */
bool fmb_open_rows_are_short(const fmb_open_rows *x, unsigned l);

/* Decide lane l. UNKNOWN: there are too many rows, or too few, or numbers are too long. */
fmb_verdict fmb_open_rows_decide(const fmb_open_rows *x, unsigned l);

#endif
