/* plane.h: the ends of a variable x when it and one more, y, are left.
 *
 * Pairing all rows in y would bound x by each pair; only the tightest counts. Let gap(x) be the
 * least upper bound of y less the greatest lower one, a concave function made of pieces of lines:
 * the greatest x with gap(x) >= 0 is found by Newton's method, from beyond it. Each step drops to
 * the zero of the piece at hand, so pieces come at most once; it costs a look at each row, and one
 * row is combined in the end. Source: Dinkelbach 1967, on Newton's method for such functions.
 */
#ifndef FMB_SOLVE_PLANE_H
#define FMB_SOLVE_PLANE_H

#include "elim/round/elim.h"

typedef struct fmb_plane {
    fmb_elim *e;
    int x, y;
    fmb_round *round; /* of y, without its combinations: back-substitution needs no more */
} fmb_plane;

/* Set y aside. False (and nothing to close): an equality names y. Errors: MEMORY, LIMIT. */
fmb_status fmb_plane_open(fmb_plane *p, fmb_elim *e, int x, int y, bool *possible);
void fmb_plane_close(fmb_plane *p);

/* The row over x alone that is tightest on the upper (sign 1) or lower side (-1), made if need be;
 * FMB_NO_ROW: there is no end. Of equal ends a strict one counts. The rows must have a solution.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_plane_extreme(fmb_plane *p, int sign, uint32_t *row);

#endif
