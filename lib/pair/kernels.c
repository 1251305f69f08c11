/* kernels.c: which width this processor has; see kernels.h. */
#include "pair/kernels.h"

const fmb_pair_kernels *fmb_pair_kernels_choose(fmb_simd level)
{
#ifdef FMB_HAVE_X86
    bool has2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    bool has512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    if (has512 && (level == FMB_SIMD_AUTO || level == FMB_SIMD_AVX512))
        return &fmb_pair_kernels_avx512;
    if (has2 && (level == FMB_SIMD_AUTO || level == FMB_SIMD_AVX2))
        return &fmb_pair_kernels_avx2;
    if (level == FMB_SIMD_AUTO || level == FMB_SIMD_PLAIN)
        return &fmb_pair_kernels_sse2;
    return NULL;
#else
    return level == FMB_SIMD_AUTO || level == FMB_SIMD_PLAIN ? &fmb_pair_kernels_one : NULL;
#endif
}
