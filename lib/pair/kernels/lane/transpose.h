/* transpose.h: numbers of records turned into lanes. */
#ifndef FMB_PAIR_TRANSPOSE_H
#define FMB_PAIR_TRANSPOSE_H

#include "pair/kernels/lane/lane.h"

/* Numbers r ... r + 3 of FMB_LANES records. */
FMB_INLINE void transpose_four(const double *const *from, int r, lane out[4])
{
#if FMB_LANES == 8
    /* Records k and k + 2 (k + 4, k + 6) side by side, so that the last shuffles put all in order.
     */
    static const int low[4] = {0, 1, 4, 5};
    __m512d x[4];
#pragma GCC unroll 4
    for (int k = 0; k < 4; k++)
        x[k] = _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(from[low[k]] + r)),
                                  _mm256_loadu_pd(from[low[k] + 2] + r), 1);
    __m512d even[2] = {_mm512_unpacklo_pd(x[0], x[1]), _mm512_unpacklo_pd(x[2], x[3])};
    __m512d odd[2] = {_mm512_unpackhi_pd(x[0], x[1]), _mm512_unpackhi_pd(x[2], x[3])};
    out[0] = _mm512_shuffle_f64x2(even[0], even[1], 0x88);
    out[1] = _mm512_shuffle_f64x2(odd[0], odd[1], 0x88);
    out[2] = _mm512_shuffle_f64x2(even[0], even[1], 0xdd);
    out[3] = _mm512_shuffle_f64x2(odd[0], odd[1], 0xdd);
#elif FMB_LANES == 4
    __m256d x[4];
    for (int k = 0; k < 4; k++)
        x[k] = _mm256_loadu_pd(from[k] + r);
    __m256d even[2] = {_mm256_unpacklo_pd(x[0], x[1]), _mm256_unpacklo_pd(x[2], x[3])};
    __m256d odd[2] = {_mm256_unpackhi_pd(x[0], x[1]), _mm256_unpackhi_pd(x[2], x[3])};
    out[0] = _mm256_permute2f128_pd(even[0], even[1], 0x20);
    out[1] = _mm256_permute2f128_pd(odd[0], odd[1], 0x20);
    out[2] = _mm256_permute2f128_pd(even[0], even[1], 0x31);
    out[3] = _mm256_permute2f128_pd(odd[0], odd[1], 0x31);
#elif FMB_LANES == 2
    for (int k = 0; k < 4; k += 2) {
        __m128d x = _mm_loadu_pd(from[0] + r + k), y = _mm_loadu_pd(from[1] + r + k);
        out[k] = _mm_unpacklo_pd(x, y);
        out[k + 1] = _mm_unpackhi_pd(x, y);
    }
#else
    for (int k = 0; k < 4; k++)
        out[k] = from[0][r + k];
#endif
}

#endif
