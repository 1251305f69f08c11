/* difference.h: the differences of points of two frames, in whole numbers: what judges depths and
 * distances in more than three dimensions. It shares nothing with what it judges.
 */
#ifndef VALIDATE_DIFFERENCE_H
#define VALIDATE_DIFFERENCE_H

#include <fmb/gmp.h>

enum {
    VALIDATE_MOST_DIM = 8,
    VALIDATE_MOST_EDGES = 2 * (VALIDATE_MOST_DIM * (VALIDATE_MOST_DIM + 1) / 2) + 1
};

/* A direction of an edge; side 2: the drift. */
typedef struct validate_edge {
    int side, corner, to; /* of a simplex: the first of its ends; its other end */
    mpz_t x[VALIDATE_MOST_DIM];
} validate_edge;

/* M = { p - q: points of P and Q at one time } = away + S0 + S1 + [0, 1] drift, S of a cuboid the
 * sums of shares of its axes, of a simplex the hull of 0 and its axes; those of Q are negated. Real
 * numbers are those of coordinate j times 2^(unit + finer[j]), but for edges, which may be shorter.
 */
typedef struct validate_difference {
    int dim, unit, finer[VALIDATE_MOST_DIM], naxes[2], edges;
    bool simplex[2], moves;
    mpz_t away[VALIDATE_MOST_DIM], drift[VALIDATE_MOST_DIM];
    mpz_t axis[2][VALIDATE_MOST_DIM][VALIDATE_MOST_DIM];
    validate_edge edge[VALIDATE_MOST_EDGES];
} validate_difference;

void validate_difference_init(validate_difference *m);
void validate_difference_clear(validate_difference *m);
/* Cuboids and simplices by edges, dim <= VALIDATE_MOST_DIM, of finite numbers. */
void validate_difference_load(validate_difference *m, const fmb_frame *p, const fmb_frame *q);

/* The least and the largest value of y.m over all m of M, whose numbers are as they are here. */
void validate_ends(validate_difference *m, mpz_t *y, mpz_t least, mpz_t most);

#endif
