/* whole_pair.h: a pair of records (minors_kernels.h) in integers.
 *
 * All edges and speeds of a pair are multiples of a power of two, and the origins are multiples of
 * another one, perhaps smaller (both are in the records): so edges and speeds are integers of a
 * word in the former unit, and origins in the latter, which is finer by a factor.
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

/* The edges of a cuboid, for B followed by the drift; the corners of a simplex, from its origin. */
typedef struct whole_body {
    bool simplex;
    int n;
    normal_vector edge[NORMAL_MOST_DIM + 1];
} whole_body;

typedef struct whole_pair {
    int dim;
    whole_body body[2];
    normal_vector shift;
    int64_t finer; /* the factor that converts edges to the unit of the shift */
} whole_pair;

/* False: numbers, or sums of all of them, have more than 56 bits. */
bool fmb_whole_pair_is_short(const whole_records *x, unsigned l);
/* Read pair l, for which fmb_whole_pair_is_short holds. */
void fmb_whole_pair_read(const whole_records *x, unsigned l, whole_pair *out);

/* Faces of A and of B: bits for vectors of a cuboid, for corners of a simplex. */
typedef struct whole_faces {
    unsigned of[2];
} whole_faces;

/* Of a simplex: the vector from corner `first` to corner `number`; of a cuboid: edge `number`. */
const normal_vector *fmb_whole_pair_edge(const whole_pair *p, int body, int first, int number,
                                         normal_vector *room);

/* The extent of a frame along n. The corners at its ends: of a cuboid bits of the edges, 1 at the
 * upper end of an edge; of a simplex numbers. */
typedef struct whole_span {
    double low, high;
    int sign[NORMAL_MOST_DIM + 1];
    int lowest, highest;
} whole_span;

/* The vector from a corner of A to one of B: from the highest of A along n to the lowest of B, or
 * from the lowest to the highest. */
void fmb_whole_pair_between(const whole_pair *p, const whole_span s[2], bool b_below,
                            normal_vector *out);

/* Keep only the first D - 1 vectors of the faces. Returns their number. */
int fmb_whole_pair_trim(const whole_pair *p, whole_faces *faces);

#endif
