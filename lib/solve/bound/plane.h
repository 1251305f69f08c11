/* plane.h: the ends of a variable x when all variables but x and y have been eliminated.
 *
 * Pairing all rows in y would bound x by each pair; only the tightest counts. Let gap(x) be the
 * least upper bound of y less its greatest lower bound, a concave piecewise linear function: the
 * greatest x with gap(x) >= 0 is found by Newton's method, starting beyond it. Each step goes to
 * the zero of the current linear piece, so each piece is used at most once; a step visits each row
 * once, and one pair of rows is combined in the end. Source: Dinkelbach 1967.
 */
#ifndef FMB_SOLVE_PLANE_H
#define FMB_SOLVE_PLANE_H

#include "elim/round/elim.h"

typedef struct fmb_plane {
    fmb_elim *e;
    int x, y;
    fmb_round *round; /* of y, without its combinations: back-substitution needs no more */
} fmb_plane;

/* Open a round for y. *possible false, nothing to close: an equality names y. Errors: as below. */
fmb_status fmb_plane_open(fmb_plane *p, fmb_elim *e, int x, int y, bool *possible);
void fmb_plane_close(fmb_plane *p);

/* The tightest row over x alone on the upper (sign 1) or lower side (-1), combined if need be;
 * FMB_NO_ROW: x is unbounded there. Among equal bounds a strict one is taken. The rows must have a
 * solution. Errors: MEMORY, LIMIT. */
fmb_status fmb_plane_extreme(fmb_plane *p, int sign, uint32_t *row);

#endif
