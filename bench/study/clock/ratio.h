/* ratio.h: ratios of paired measurements, with confidence intervals.
 *
 * Numbers come in pairs: the times of two ways in the same pass, or on the same system. The
 * interval is the bootstrap's: pairs are drawn with replacement, 1000 times, from a fixed seed, and
 * 95 % of the ratios lie in it (Efron and Tibshirani 1993, percentile interval). With few pairs it
 * is unreliable: with one it is a point.
 */
#ifndef FMB_STUDY_RATIO_H
#define FMB_STUDY_RATIO_H

#include <stddef.h>

/* All NaN if there are no pairs; only the interval is NaN if memory runs out. */
typedef struct study_ratio {
    double ratio;
    double low, high;   /* ends of the interval */
    double least, most; /* ratio of a pair */
} study_ratio;

/* The median of a[0..n) over that of b[0..n), as a reader of both medians would divide them. It
 * lies between the least and the largest ratio of a pair. */
study_ratio study_ratio_of_medians(const double *a, const double *b, size_t n);
/* The median of a[i] / b[i]. */
study_ratio study_median_of_ratios(const double *a, const double *b, size_t n);
/* The sum of a over that of b. */
study_ratio study_ratio_of_sums(const double *a, const double *b, size_t n);

#endif
