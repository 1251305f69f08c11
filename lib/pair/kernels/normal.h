/* normal.h: minors of integer vectors, each as a double and as its lowest words. If the double does
 * not determine the sign of a minor, it bounds its size, so that the lowest words are exact.
 *
 * An entry of vector i is at most a_i, and its double has at most one rounding error (u = 2^-53). A
 * minor of k vectors is at most k! a_1 ... a_k, with an error of m_k u times that: m_1 = 1, and
 * each of the k + 1 products of an entry and a minor inherits m_k + 1 and is rounded at most k + 1
 * times, so m_(k+1) = m_k + 1 + (k + 1) and m_k = k (k + 1) / 2 - 1 + k.
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

/* The normal n of D - 1 vectors: its coordinates are their minors of that order. */
typedef struct normal {
    int words, dim;
    int known, taken[NORMAL_MOST_DIM]; /* how many vectors have known minors, and their numbers */
    double error;                      /* of all minors, and of products with n */
    double near[1 << NORMAL_MOST_DIM]; /* minors, by the set of their coordinates */
    uint64_t low[1 << NORMAL_MOST_DIM][NORMAL_WORDS]; /* the first `words` of each */
} normal;

/* An upper bound of m_k k!: the error of a minor in units of u a_1 ... a_k. */
static inline double normal_error(int k)
{
    static const double FACTORIAL[] = {1, 1, 2, 6, 24, 120, 720, 5040, 40320};
    return 1.01 * FACTORIAL[k] * (k * (k + 1) / 2 - 1 + k);
}

/* The number of words for an integer whose double is at most `error`, its own error bound; 0: too
 * many. */
static inline int normal_words(double error)
{
    return error < 0x1p61 ? 1 : error < 0x1p125 ? 2 : error < 0x1p189 ? 3 : 0;
}

/* Begin a normal whose numbers have so many words. */
void fmb_normal_begin(int words, int dim, double error, normal *n);

/* Put vector `number` at place `at`, unless it is there already. Are all minors of the first at + 1
 * vectors 0? */
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

/* The sign of n v, given its approximation `near` with an error of at most `error` <= n->error. */
int fmb_normal_sign(const normal *n, double near, double error, const int64_t *v);

#endif
