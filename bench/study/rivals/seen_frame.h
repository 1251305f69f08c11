/* seen_frame.h: the second frame in coordinates of the first, by the inverse of its axes; inlined,
 * so that for a constant number of dimensions the compiler removes loops and arrays. */
#ifndef FMB_STUDY_SEEN_FRAME_H
#define FMB_STUDY_SEEN_FRAME_H

#include <math.h>

#include "study/rivals/rows.h"

#define STUDY_INLINE static inline __attribute__((always_inline))

/* Two or three axes: cofactors over the determinant. Returns the determinant. */
STUDY_INLINE double study_rows_invert_by_cofactors(int dim, const double *a, double *to)
{
    double det;
    if (dim == 2) {
        det = a[0] * a[3] - a[1] * a[2];
        to[0] = a[3] / det;
        to[1] = -a[2] / det;
        to[2] = -a[1] / det;
        to[3] = a[0] / det;
        return det;
    }
    for (int i = 0; i < 3; i++) {
        const double *p = a + 3 * ((i + 1) % 3), *q = a + 3 * ((i + 2) % 3);
        for (int j = 0; j < 3; j++)
            to[3 * i + j] = p[(j + 1) % 3] * q[(j + 2) % 3] - p[(j + 2) % 3] * q[(j + 1) % 3];
    }
    det = a[0] * to[0] + a[1] * to[1] + a[2] * to[2];
    for (int i = 0; i < 9; i++)
        to[i] /= det;
    return det;
}

/* Any number of axes, by elimination. Rows of `a` are axes, so column i of its inverse is 1 on axis
 * i and 0 on the others. Returns the determinant. */
double study_rows_invert_by_elimination(int dim, const double *a, double *to);

/* to[i * dim ...] becomes the functional that is 1 on axis i and 0 on the others. False if there is
 * none. */
STUDY_INLINE bool study_rows_invert(int dim, const fmb_frame *p, double least, double *to)
{
    double det = dim == 2 || dim == 3 ? study_rows_invert_by_cofactors(dim, p->axes, to)
                                      : study_rows_invert_by_elimination(dim, p->axes, to);
    return fabs(det) >= least && det != 0;
}

STUDY_INLINE double study_rows_dot(int dim, const double *x, const double *y)
{
    double sum = 0;
    for (int j = 0; j < dim; j++)
        sum += x[j] * y[j];
    return sum;
}

/* False if p has no inverse: |det p| < least or 0. p has all axes. */
STUDY_INLINE bool study_rows_see(int dim, const fmb_frame *p, const fmb_frame *q, double least,
                                 study_rows_image *out)
{
    double shift[STUDY_ROWS_MOST_DIM], drift[STUDY_ROWS_MOST_DIM],
        inverse[STUDY_ROWS_MOST_DIM * STUDY_ROWS_MOST_DIM];
    if (!study_rows_invert(dim, p, least, inverse))
        return false;
    bool moves = p->speed || q->speed;
    for (int j = 0; j < dim; j++) {
        shift[j] = q->origin[j] - p->origin[j];
        if (moves)
            drift[j] = (q->speed ? q->speed[j] : 0) - (p->speed ? p->speed[j] : 0);
    }
    for (int i = 0; i < dim; i++) {
        out->base[i] = study_rows_dot(dim, inverse + i * dim, shift);
        for (int k = 0; k < dim; k++)
            out->to[i][k] = study_rows_dot(dim, inverse + i * dim, q->axes + k * dim);
        if (moves)
            out->to[i][dim] = study_rows_dot(dim, inverse + i * dim, drift);
    }
    return true;
}

#endif
