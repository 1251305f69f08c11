/* polar_points.h: rows as points, seen from a point strictly inside.
 *
 * Seen from x, row a.y <= b is the point p = a / (b - a.x) of the polar: a ray from x in direction
 * w (ray.h) meets row i at the time 1 / (w.p_i). The point x is exact, and proved to be strictly
 * inside of every row.
 */
#ifndef FMB_LP_POLAR_POINTS_H
#define FMB_LP_POLAR_POINTS_H

#include <gmp.h>

#include "lp/model/row.h"
#include "trace/run.h"

typedef struct fmb_polar_points {
    fmb_mem *mem;
    const fmb_kernels *kernels;
    size_t n, m, d; /* columns, rows, and columns with a nonzero */
    const fmb_lp_row *row;
    size_t *column; /* [d] */
    int *exponent;  /* [d] column k is divided by 2^exponent, and so x_k is multiplied by it */
    mpz_t *x;       /* [d] the point: x / 2^shift */
    int shift;
    size_t *order;    /* [m] rows in their order here; neighbours are near each other */
    size_t *place;    /* [m] the place of each row in it */
    double *point_at; /* [d][m] polar points, by place; 0 for hidden rows */
    double *size;     /* [m] their lengths */
    double *round;    /* [d][m] the points in coordinates that make the hull about round */
    double *half;     /* [d][d] lower triangle: point_at = half round */
    size_t blocks;
    double *middle; /* [blocks][d] the middle of the points of a block, */
    double *radius; /* [blocks] bound on their distances from it, */
    double *reach;  /* [blocks] and bound on their lengths */
} fmb_polar_points;

/* *inside false: no point was found, though there may be one. Errors: MEMORY, LIMIT; call
 * fmb_polar_points_clear even then. */
fmb_status fmb_polar_points_open(fmb_polar_points *p, fmb_run *run, size_t n, size_t m,
                                 const fmb_lp_row *row, bool *inside);
void fmb_polar_points_clear(fmb_polar_points *p);
/* The point inside, x[n]. */
void fmb_polar_points_point(const fmb_polar_points *p, mpq_t *x);
/* Ignore row i from now on. */
void fmb_polar_points_hide(fmb_polar_points *p, size_t i);
/* q[d] = the point of row i, in round coordinates. */
void fmb_polar_points_round_point(const fmb_polar_points *p, size_t i, double *q);

/* ---- for the other files of this room -------------------------------------------------------- */

/* Points are grouped into blocks of this size. */
#define FMB_SPATIAL_BLOCK 64
/* Sort the points so that neighbours are near each other. */
void fmb_polar_points_arrange(fmb_polar_points *p);
/* slack = 2^shift b - a.x of row i. */
void fmb_polar_points_slack(const fmb_polar_points *p, size_t i, mpz_t slack, mpz_t t);

#endif
