/* whole_pair.h: a pair of records (minors_kernels.h) in whole numbers.
 *
 * All edges and speeds of a pair are multiples of a power of two, the origins of one that may be
 * less (their records say which): so they are whole numbers of a word, and the others are finer by
 * a factor.
 */
#ifndef FMB_PAIR_KERNELS_WHOLE_PAIR_H
#define FMB_PAIR_KERNELS_WHOLE_PAIR_H

#include <stdbool.h>

#include "pair/kernels/normal.h"

/* Records of pairs side by side: number r of that of pair l is record[..][r * width + l]. */
typedef struct whole_records {
    int dim, width;
    bool moves, simplex[2];
    const double *record[2];
} whole_records;

/* The edges of a cuboid, the drift behind those of B; the corners of a simplex, from its origin. */
typedef struct whole_body {
    bool simplex;
    int n;
    normal_vector edge[NORMAL_MOST_DIM + 1];
} whole_body;

typedef struct whole_pair {
    int dim;
    whole_body body[2];
    normal_vector shift;
    int64_t finer; /* what edges are to be multiplied by beside the shift */
} whole_pair;

/* False: numbers have more than 56 bits, also as sums of all. */
bool fmb_whole_pair_is_short(const whole_records *x, unsigned l);
/* That is so. */
void fmb_whole_pair_read(const whole_records *x, unsigned l, whole_pair *out);

/* Faces of A and of B: bits for vectors of a cuboid, for corners of a simplex. */
typedef struct whole_faces {
    unsigned of[2];
} whole_faces;

/* A vector of that body from corner `first`, of a cuboid 0, to corner `number`, or that edge. */
const normal_vector *fmb_whole_pair_edge(const whole_pair *p, int body, int first, int number,
                                         normal_vector *room);

/* How far a frame reaches along n. Its corners are the signs of its edges, 1 at the upper end; of a
 * simplex numbers. */
typedef struct whole_span {
    double low, high;
    int sign[NORMAL_MOST_DIM + 1];
    int lowest, highest;
} whole_span;

/* The way from a corner of A to one of B: from where these are high and low along n, or the other
 * way round. */
void fmb_whole_pair_between(const whole_pair *p, const whole_span s[2], bool b_below,
                            normal_vector *out);

/* Vectors of faces but for the first D - 1 are left out. How many there are then. */
int fmb_whole_pair_trim(const whole_pair *p, whole_faces *faces);

#endif
