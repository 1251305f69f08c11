/* centre.h: a point well inside a polyhedron, and an ellipsoid there. In doubles: a guess.
 *
 * The analytic centre of rows a_i.x <= b_i maximizes the product of all b_i - a_i.x. The second
 * derivative of its logarithm there, H = sum_i a_i a_i^T / (b_i - a_i.x)^2, gives an ellipsoid
 * inside the polyhedron; enlarged m times it contains the polyhedron. Source: Boyd and Vandenberghe
 * 2004, Convex optimization, sections 8.5.3, 9.6 and 11.4.
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
    double *x;      /* [n + 1] the point; then the relaxation of rows */
    double *slack;  /* [m] right - at.x */
    double *half;   /* [n + 1][n + 1] lower triangle L of H = L L^T */
    double *way;    /* [n + 1] scratch */
    double *speed;  /* [m] scratch */
    double room;    /* |x_k - middle_k| < room, while that applies */
    double *middle; /* [n] the initial x */
} fmb_centre;

/* Memory for m rows of n numbers: the caller fills in at[n][m] and right[m]. Errors: MEMORY, LIMIT.
 * The caller must call fmb_centre_clear even then. */
fmb_status fmb_centre_init(fmb_centre *c, fmb_mem *mem, size_t n, size_t m);
void fmb_centre_clear(fmb_centre *c);
/* Rows should have length about 1. *inside: x is near the centre, slack > 0, and half is L there
 * for n columns, without gaps; otherwise the interior seems empty. Errors: LIMIT. */
fmb_status fmb_centre_find(fmb_centre *c, fmb_run *run, bool *inside);

#endif
