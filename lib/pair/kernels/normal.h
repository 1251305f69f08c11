/* normal.h: minors of vectors of whole numbers, each as a double and as its lowest words. Where the
 * double does not tell the sign of one it bounds it, and the lowest words are all of it.
 *
 * A number of vector i is at most a_i, and is off by one rounding at most as a double (u = 2^-53).
 * A minor of k vectors is at most k! a_1 ... a_k, and off by m_k u of that: m_1 = 1, and of k + 1
 * products of a number and a minor each inherits m_k + 1 and is rounded k + 1 times at most, so
 * m_(k+1) = m_k + 1 + (k + 1) and m_k = k (k + 1) / 2 - 1 + k.
 */
#ifndef FMB_PAIR_KERNELS_NORMAL_H
#define FMB_PAIR_KERNELS_NORMAL_H

#include <math.h>

#include "pair/kernels/minors_kernels.h"

enum { NORMAL_MOST_DIM = FMB_MINORS_MOST_DIM, NORMAL_WORDS = 3 };

typedef struct normal_vector {
    int64_t whole[NORMAL_MOST_DIM];
    double near[NORMAL_MOST_DIM], most; /* the largest absolute value */
} normal_vector;

/* D - 1 vectors are perpendicular to their minors of that size, the direction n. */
typedef struct normal {
    int words, dim;
    int known, taken[NORMAL_MOST_DIM]; /* vectors whose minors are known, and which these are */
    double error;                      /* of all minors that are made, and of what n says */
    double near[1 << NORMAL_MOST_DIM]; /* minors, by the set of their coordinates */
    uint64_t low[1 << NORMAL_MOST_DIM][NORMAL_WORDS]; /* the first `words` of each */
} normal;

/* How many u k! a_1 ... a_k the error of a minor may be, a little more; that times k!. */
static inline double normal_error(int k)
{
    static const double FACTORIAL[] = {1, 1, 2, 6, 24, 120, 720, 5040, 40320};
    return 1.01 * FACTORIAL[k] * (k * (k + 1) / 2 - 1 + k);
}

/* So many words hold a number that is off by `error`, if as a double it is no more than that; 0:
 * too many. */
static inline int normal_words(double error)
{
    return error < 0x1p61 ? 1 : error < 0x1p125 ? 2 : error < 0x1p189 ? 3 : 0;
}

/* Numbers of n have so many words. */
void fmb_normal_begin(int words, int dim, double error, normal *n);

/* The vector of that number goes to place `at`, unless it is the one that stands there. Are all
 * minors of the first at + 1 vectors 0? */
bool fmb_normal_put(int at, int number, const normal_vector *v, normal *n);

/* n v as a double. */
static inline double normal_near(const normal *n, const double *v)
{
    const unsigned all = (1U << n->dim) - 1;
    double sum[2] = {0, 0};
    for (int r = 0; r < n->dim; r++)
        sum[r % 2] += n->near[all & ~(1U << r)] * v[r];
    return sum[0] - sum[1];
}

/* The sign of n v, which is `near` but for that error, no more than that of n. */
int fmb_normal_sign(const normal *n, double near, double error, const int64_t *v);

#endif
