/* maker.h: a system while it is made from frames.
 *
 * All numbers are whole (frame_integers.h). Where the coordinates c of a frame are variables, its
 * rows are written as they come, each with the few terms that it has. Where they are not, they
 * solve A c = p - origin - t speed for the point p. Gauss and Jordan's elimination on [A | p -
 * origin - t speed], whose right part is affine forms of the variables (vars coefficients, then the
 * constant), leaves them, times a determinant, as forms in the rows with pivots, and one equality 0
 * = form in each row without.
 */
#ifndef FMB_FRAME_MAKER_H
#define FMB_FRAME_MAKER_H

#include "frame/frame_integers.h"

typedef struct fmb_maker {
    fmb_scene scene;
    fmb_coordinates in;
    fmb_rel inside; /* of the rows that hold a frame's coordinates */
    fmb_system *s;
    int dim;
    int vars, time; /* columns; the one of t, or -1 */
    int width;      /* most axes + vars + 1 */
    mpz_t *cell;    /* all that follows [cells] */
    size_t cells;
    mpz_t *table; /* [dim][width], unless all coordinates are variables */
    mpz_t *sum;   /* [vars + 1] */
    mpz_t *row;   /* [vars + 2] a row on its way into the system */
    int *var;     /* [vars] of row */
    mpz_t *scale; /* of the solved coordinates: they are form / scale */
    mpz_t *spare; /* one number */
    fmb_run *run; /* whose limits hold, or NULL */
} fmb_maker;

/* Append all rows to m->s. Errors: ARG (dependent axes), MEMORY, LIMIT. */
fmb_status fmb_maker_rows(const fmb_maker *m);

#endif
