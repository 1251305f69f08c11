/* pair_kernels.c: which width this processor has; see pair_kernels.h. */
#include "pair/kernels/pair_kernels.h"

const fmb_pair_kernels *fmb_pair_kernels_choose(fmb_simd level)
{
#ifdef FMB_PAIR_AVX512
    if ((level == FMB_SIMD_AUTO || level == FMB_SIMD_AVX512) && __builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512dq"))
        return &fmb_pair_kernels_avx512;
#endif
#ifdef FMB_PAIR_AVX2
    if ((level == FMB_SIMD_AUTO || level == FMB_SIMD_AVX2) && __builtin_cpu_supports("avx2") &&
        __builtin_cpu_supports("fma"))
        return &fmb_pair_kernels_avx2;
#endif
    return level == FMB_SIMD_AUTO || level == FMB_SIMD_PLAIN ? &fmb_pair_kernels_narrow : NULL;
}
