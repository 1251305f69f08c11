/* kernels_choose.c: which instructions this processor has; see kernels.h. */
#include "num/kernels/kernels.h"

const fmb_kernels *fmb_kernels_choose(fmb_simd level)
{
#ifdef FMB_HAVE_X86
    bool has2 = __builtin_cpu_supports("avx2");
    bool has512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vpopcntdq");
    if (has512 && (level == FMB_SIMD_AUTO || level == FMB_SIMD_AVX512))
        return &fmb_kernels_avx512;
    if (has2 && (level == FMB_SIMD_AUTO || level == FMB_SIMD_AVX2))
        return &fmb_kernels_avx2;
#endif
    return level == FMB_SIMD_AUTO || level == FMB_SIMD_PLAIN ? &fmb_kernels_plain : NULL;
}
