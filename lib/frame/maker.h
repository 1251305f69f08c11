/* maker.h: a system while it is made from frames.
 *
 * Everything is an affine form of the variables: vars coefficients, then the constant, all whole
 * numbers (whole.h). A point p of R^D is D forms. Its coordinates in a frame solve
 * A c = p - origin - t speed; Gauss and Jordan's elimination on [A | p - origin - t speed] leaves
 * them, times a determinant, as forms in the rows with pivots, and one equality 0 = form in each
 * row without.
 */
#ifndef FMB_FRAME_MAKER_H
#define FMB_FRAME_MAKER_H

#include "frame/whole.h"

typedef struct fmb_maker {
    fmb_scene scene;
    fmb_coordinates in;
    fmb_rel inside; /* of the rows that hold a frame's coordinates */
    fmb_system *s;
    int dim;
    int vars, time; /* columns; the one of t, or -1 */
    int width;      /* most axes + vars + 1 */
    mpz_t *cell;    /* the work table, [dim][width]; what follows lies behind it */
    size_t cells;
    mpz_t *form, *sum; /* [vars + 1] */
    mpz_t *row;        /* [vars + 2] a row on its way into the system */
    mpz_t *scale;      /* of the coordinates at hand: they are form / scale; and room for a gcd */
    int *var;          /* [vars] of row */
} fmb_maker;

/* Append all rows to m->s. Errors: ARG (dependent axes), MEMORY. */
fmb_status fmb_maker_rows(const fmb_maker *m);

#endif
