/* rows.h: the system of a pair in doubles, as the article sets it up: the second frame in
 * coordinates of the first, through an inverse. It is rounded, so the library never uses it;
 * algorithms that studies measure start from it.
 *
 * Source: Baillehache 2020, "Formulation of the problem".
 */
#ifndef FMB_STUDY_ROWS_H
#define FMB_STUDY_ROWS_H

#include <fmb/frame.h>

enum {
    STUDY_ROWS_MOST_DIM = 8,
    STUDY_ROWS_MOST_COLUMNS = STUDY_ROWS_MOST_DIM + 2, /* c, t and the right side */
    STUDY_ROWS_MOST = 4 * STUDY_ROWS_MOST_DIM + 2
};

typedef struct study_rows {
    int n;      /* variables: c of the second frame, then t if anything moves; all in 0 ... 1 */
    int m;      /* rows */
    int facets; /* of the first frame: the first rows */
    double a[STUDY_ROWS_MOST][STUDY_ROWS_MOST_COLUMNS]; /* a[i] x <= a[i][n] */
} study_rows;

/* The second frame in coordinates of the first: coordinate i of a point is base[i] plus the sum
 * over the variables x of to[i][k] x_k. */
typedef struct study_rows_image {
    double base[STUDY_ROWS_MOST_DIM], to[STUDY_ROWS_MOST_DIM][STUDY_ROWS_MOST_DIM + 1];
} study_rows_image;

/* Rows of p's lower ends, its upper ends, q's upper ends, its lower ends, those of time. Both
 * frames have all axes of at most STUDY_ROWS_MOST_DIM. False if p has no inverse. */
bool study_rows_make(const fmb_frame *p, const fmb_frame *q, double least, study_rows *out);

#endif
