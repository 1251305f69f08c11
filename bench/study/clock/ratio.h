/* ratio.h: how many times one is the other, and how sure that is.
 *
 * Numbers come in pairs: the times of two ways in the same pass, or on the same system. The
 * interval is the bootstrap's: pairs are drawn with replacement, 1000 times, from a fixed seed, and
 * 95 % of the ratios lie in it (Efron and Tibshirani 1993, percentile interval). Few pairs say
 * little: of one the interval is a point.
 */
#ifndef FMB_STUDY_RATIO_H
#define FMB_STUDY_RATIO_H

#include <stddef.h>

/* All NaN if there are no numbers; the interval alone for want of memory. */
typedef struct study_ratio {
    double ratio;
    double low, high;   /* of the interval */
    double least, most; /* of a pair */
} study_ratio;

/* The median of a[0..n) over that of b[0..n): what a reader finds who divides the medians. It lies
 * between the least and the most. */
study_ratio study_ratio_of_medians(const double *a, const double *b, size_t n);
/* The median of a[i] / b[i]. */
study_ratio study_median_of_ratios(const double *a, const double *b, size_t n);
/* The sum of a over that of b. */
study_ratio study_ratio_of_sums(const double *a, const double *b, size_t n);

#endif
