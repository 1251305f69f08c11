/* maker.h: the construction of a system from frames.
 *
 * All numbers are integers (frame_integers.h). Where the coordinates c of a frame are variables,
 * its rows are written directly, each with its few terms. Otherwise c solves A c = p - origin -
 * t speed for the point p. Gauss-Jordan elimination on [A | p - origin - t speed], whose right part
 * consists of affine forms of the variables (vars coefficients, then the constant), gives each
 * coordinate, times a determinant, as the form in a row with a pivot, and the equality 0 = form for
 * each row without one.
 */
#ifndef FMB_FRAME_MAKER_H
#define FMB_FRAME_MAKER_H

#include "frame/frame_integers.h"

typedef struct fmb_maker {
    fmb_scene scene;
    fmb_coordinates in;
    fmb_rel inside; /* relation of the rows that bound a frame's coordinates */
    fmb_system *s;
    int dim;
    int vars, time; /* number of columns; the column of t, or -1 */
    int width;      /* most axes + vars + 1 */
    mpz_t *cell;    /* [cells] the memory of all numbers below */
    size_t cells;
    mpz_t *table; /* [dim][width], unless all coordinates are variables */
    mpz_t *sum;   /* [vars + 1] */
    mpz_t *row;   /* [vars + 2] the row being made */
    int *var;     /* [vars] of row */
    mpz_t *scale; /* of the solved coordinates: they are form / scale */
    mpz_t *spare; /* one number */
    fmb_run *run; /* its limits apply; or NULL */
} fmb_maker;

/* Append all rows to m->s. Errors: ARG (dependent axes), MEMORY, LIMIT. */
fmb_status fmb_maker_rows(const fmb_maker *m);

#endif
