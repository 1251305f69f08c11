/* interior_point.h: a point strictly inside, and which rows are seen from there. */
#ifndef FMB_LP_INTERIOR_POINT_H
#define FMB_LP_INTERIOR_POINT_H

#include "lp/model/row.h"
#include "trace/run.h"

typedef struct fmb_interior_point {
    fmb_run *run;
    size_t n, m;
    const fmb_lp_row *row;
    double *x;       /* [n] the point, exactly */
    int precision;   /* its coordinates are multiples of 2^-precision */
    int64_t *slack;  /* [m] 2^precision (b - a.x) > 0 */
    double *unit;    /* [n + 1][m] column by column, rows by their lengths |a|; the last is -b */
    double *entry;   /* [n][m] column by column, as they are */
    double *excess;  /* [m] scratch: how far x is beyond each row */
    bool near;       /* rows near those are meant: coefficients differ by less than 1 each, */
    bool near_right; /* and right sides do so, too; else they are the same */
} fmb_interior_point;

/* Inequalities of at most 29 bits, most of them about as far from 0 as their coefficients are long
 * (leading_rows.h makes them so). *possible false: there are too many columns. Errors: MEMORY. In
 * any case fmb_interior_point_clear it. */
fmb_status fmb_interior_point_open(fmb_interior_point *p, fmb_run *run, size_t n, size_t m,
                                   const fmb_lp_row *row, bool *possible);
/* Look for a point strictly inside all of the rows, from where the last search ended. *found false:
 * none was found. A glance costs little. Errors: LIMIT. */
fmb_status fmb_interior_point_find(fmb_interior_point *p, bool *found);
fmb_status fmb_interior_point_find_quickly(fmb_interior_point *p, bool *found);
/* Work (trace/run.h) that a search takes which is no glance, at most. */
double fmb_interior_point_most_work(const fmb_interior_point *p);
/* Is the point found strictly inside all rows near those? False: that is not certain. */
bool fmb_interior_point_sees_near_rows(const fmb_interior_point *p);
void fmb_interior_point_clear(fmb_interior_point *p);
/* The row among those not gone (NULL: all) that a ray from the point in direction way[n] (roughly)
 * meets before any other, whatever rows near those are meant, which see the point: it is
 * irredundant. SIZE_MAX: it meets several at once, or none, or that is not certain. speed[m]:
 * scratch. Exact. */
size_t fmb_interior_point_shoot(const fmb_interior_point *p, const double *way, const bool *gone,
                                double *speed);

#endif
