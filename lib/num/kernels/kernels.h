/* kernels.h: the inner loops, once for each set of instructions; chosen at run time.
 *
 * Sets are bit sets of `words` words, stored in planes: word k of set j is planes[k * stride + j],
 * so that neighbouring sets lie side by side. stride is a multiple of 8 and the sets between count
 * and stride are readable.
 */
#ifndef FMB_NUM_KERNELS_H
#define FMB_NUM_KERNELS_H

#include <fmb/options.h>

typedef struct fmb_planes {
    const uint64_t *bits; /* [words * stride] */
    size_t stride, words, count;
} fmb_planes;

typedef struct fmb_kernels {
    /* Set bit j of drop if the union of a and set j has more than `most` elements. */
    void (*larger)(const fmb_planes *p, const uint64_t *a, int most, uint64_t *drop);
    /* How many sets are subsets of u; counting may stop once there are `enough`. */
    size_t (*inside)(const fmb_planes *p, const uint64_t *u, size_t enough);
    /* dst = p a + q b, all less than 2^62 in absolute value; returns the bitwise or of the
     * |dst[i]|. dst may be a. `narrow`: p, q, a, b are less than 2^31. */
    uint64_t (*combine)(int64_t *dst, const int64_t *a, const int64_t *b, size_t n, int64_t p,
                        int64_t q);
    uint64_t (*combine_narrow)(int64_t *dst, const int64_t *a, const int64_t *b, size_t n,
                               int64_t p, int64_t q);
    /* out[i] += y x[i]. */
    void (*accumulate)(double *out, const double *x, size_t n, double y);
} fmb_kernels;

/* The kernels of a level; NULL if this processor or compiler lacks its instructions. */
const fmb_kernels *fmb_kernels_choose(fmb_simd level);

/* ---- for the other files of this room -------------------------------------------------------- */

extern const fmb_kernels fmb_kernels_plain;
#if defined __x86_64__ && defined __GNUC__
#define FMB_HAVE_X86
extern const fmb_kernels fmb_kernels_avx2, fmb_kernels_avx512;
#endif

#endif
