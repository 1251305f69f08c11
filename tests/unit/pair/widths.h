/* widths.h: the kernels of every width that this processor has, for tests that ask all of them, or
 * what KERNELS_TESTED makes of them. */
#ifndef FMB_TESTS_PAIR_WIDTHS_H
#define FMB_TESTS_PAIR_WIDTHS_H

#include "pair/kernels/pair_kernels.h"

#ifndef KERNELS_TESTED
#define KERNELS_TESTED(kernels) (kernels)
#endif

enum { WIDTHS = 4 };

/* One pair at a time, as on processors without vectors. */
extern const fmb_pair_kernels kernels_plain;

static inline int widths(const fmb_pair_kernels *out[WIDTHS])
{
    const fmb_simd level[3] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};
    int n = 0;
#ifdef HAVE_PLAIN
    out[n++] = &kernels_plain;
#endif
    for (int i = 0; i < 3; i++) {
        const fmb_pair_kernels *k = fmb_pair_kernels_choose(level[i]);
        if (k && k->width > 1)
            out[n++] = KERNELS_TESTED(k);
    }
    return n;
}

#endif
