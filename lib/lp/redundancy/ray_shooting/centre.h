/* centre.h: a point well inside a polyhedron, and how wide it is there. In doubles: a guess.
 *
 * The analytic centre of rows a_i.x <= b_i is where the product of all b_i - a_i.x is greatest. The
 * second derivative of its logarithm there, H = sum_i a_i a_i^T / (b_i - a_i.x)^2, makes an
 * ellipsoid that lies inside; blown up m times it holds the whole polyhedron. Source: Boyd and
 * Vandenberghe 2004, Convex optimization, sections 8.5.3, 9.6 and 11.4.
 */
#ifndef FMB_LP_CENTRE_H
#define FMB_LP_CENTRE_H

#include "base/mem.h"
#include "trace/run.h"

typedef struct fmb_centre {
    fmb_mem *mem;
    size_t n, m;
    double *at;     /* [n + 1][m] coefficients by column; then -1, or a row's length */
    double *right;  /* [m] */
    double *x;      /* [n + 1] the point; then how far rows are moved out */
    double *slack;  /* [m] right - at.x */
    double *half;   /* [n + 1][n + 1] lower triangle L of H = L L^T */
    double *way;    /* [n + 1] scratch */
    double *speed;  /* [m] scratch */
    double room;    /* |x_k - x_k at first| < room, when that counts */
    double *middle; /* [n] x at first */
} fmb_centre;

/* Room for m rows of n numbers: fill in at[n][m] and right[m]. Errors: MEMORY, LIMIT. In any case
 * fmb_centre_clear it. */
fmb_status fmb_centre_init(fmb_centre *c, fmb_mem *mem, size_t n, size_t m);
void fmb_centre_clear(fmb_centre *c);
/* Rows should be of length about 1. *inside: x is about the centre, slack > 0, and half is that of
 * n columns there, one after another; else there seems to be no inside. Errors: LIMIT. */
fmb_status fmb_centre_find(fmb_centre *c, fmb_run *run, bool *inside);

#endif
