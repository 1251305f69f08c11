/* polar_points.h: rows as points, seen from a point strictly inside.
 *
 * Seen from x, row a.y <= b is the point a / (b - a.x) of the polar: a ray from x in direction w
 * (ray.h) meets row i at the time 1 / (w.p_i). The point x is exact, and strictly inside of every
 * row, exactly.
 */
#ifndef FMB_LP_POLAR_POINTS_H
#define FMB_LP_POLAR_POINTS_H

#include <gmp.h>

#include "lp/model/row.h"
#include "trace/run.h"

typedef struct fmb_polar_points {
    fmb_mem *mem;
    const fmb_kernels *kernels;
    size_t n, m, d; /* columns, rows, and columns that some row names */
    const fmb_lp_row *row;
    size_t *column; /* [d] */
    int *exponent;  /* [d] column k counts 2^exponent times what it is */
    mpz_t *x;       /* [d] the point: x / 2^shift */
    int shift;
    size_t *order;    /* [m] rows as they stand here; neighbours in it are near each other */
    size_t *place;    /* [m] where a row stands */
    double *point_at; /* [d][m] polar points, by place; 0 for rows that are hidden */
    double *size;     /* [m] their lengths */
    double *round;    /* [d][m] the same points in coordinates in which the hull is about round */
    double *half;     /* [d][d] lower triangle: point_at = half round */
    size_t blocks;
    double *middle; /* [blocks][d] of the points of a block, */
    double *radius; /* [blocks] from where none is farther than this, */
    double *reach;  /* [blocks] and none longer than that */
} fmb_polar_points;

/* *inside false: no point was found; there may be one. Errors: MEMORY, LIMIT. In any case
 * fmb_polar_points_clear it. */
fmb_status fmb_polar_points_open(fmb_polar_points *p, fmb_run *run, size_t n, size_t m,
                                 const fmb_lp_row *row, bool *inside);
void fmb_polar_points_clear(fmb_polar_points *p);
/* The point inside, x[n]. */
void fmb_polar_points_point(const fmb_polar_points *p, mpq_t *x);
/* Row i does not count any longer. */
void fmb_polar_points_hide(fmb_polar_points *p, size_t i);
/* q[d] = the point of row i, in round coordinates. */
void fmb_polar_points_round_point(const fmb_polar_points *p, size_t i, double *q);

/* ---- for the other files of this room -------------------------------------------------------- */

/* Points stand together in blocks of so many. */
#define FMB_SPATIAL_BLOCK 64
/* Find an order with neighbours near each other, and put the points into it. */
void fmb_polar_points_arrange(fmb_polar_points *p);
/* slack = 2^shift b - a.x of row i. */
void fmb_polar_points_slack(const fmb_polar_points *p, size_t i, mpz_t slack, mpz_t t);

#endif
