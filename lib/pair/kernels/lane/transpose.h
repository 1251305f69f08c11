/* transpose.h: transposing numbers of records into lanes. */
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

/* The same of records of floats. */
FMB_INLINE void transpose_four_single(const float *const *from, int r, lane out[4])
{
#if FMB_LANES >= 4
    __m128 x[FMB_LANES];
#pragma GCC unroll 8
    for (int k = 0; k < FMB_LANES; k++)
        x[k] = _mm_loadu_ps(from[k] + r);
#endif
#if FMB_LANES == 8
    __m256 row[4];
#pragma GCC unroll 4
    for (int k = 0; k < 4; k++)
        row[k] = _mm256_insertf128_ps(_mm256_castps128_ps256(x[k]), x[k + 4], 1);
    __m256 low[2] = {_mm256_unpacklo_ps(row[0], row[1]), _mm256_unpacklo_ps(row[2], row[3])};
    __m256 high[2] = {_mm256_unpackhi_ps(row[0], row[1]), _mm256_unpackhi_ps(row[2], row[3])};
    out[0] = _mm512_cvtps_pd(_mm256_shuffle_ps(low[0], low[1], 0x44));
    out[1] = _mm512_cvtps_pd(_mm256_shuffle_ps(low[0], low[1], 0xee));
    out[2] = _mm512_cvtps_pd(_mm256_shuffle_ps(high[0], high[1], 0x44));
    out[3] = _mm512_cvtps_pd(_mm256_shuffle_ps(high[0], high[1], 0xee));
#elif FMB_LANES == 4
    _MM_TRANSPOSE4_PS(x[0], x[1], x[2], x[3]);
#pragma GCC unroll 4
    for (int k = 0; k < 4; k++)
        out[k] = _mm256_cvtps_pd(x[k]);
#elif FMB_LANES == 2
    __m128 x = _mm_loadu_ps(from[0] + r), y = _mm_loadu_ps(from[1] + r);
    __m128 low = _mm_unpacklo_ps(x, y), high = _mm_unpackhi_ps(x, y);
    out[0] = _mm_cvtps_pd(low);
    out[1] = _mm_cvtps_pd(_mm_movehl_ps(low, low));
    out[2] = _mm_cvtps_pd(high);
    out[3] = _mm_cvtps_pd(_mm_movehl_ps(high, high));
#else
    for (int k = 0; k < 4; k++)
        out[k] = from[0][r + k];
#endif
}

/* The first n numbers of FMB_LANES records, n constant, and 9 at most. */
FMB_INLINE void transpose_some(const double *const *from, int n, lane *out)
{
#pragma GCC unroll 2
    for (int r = 0; r + 4 <= n; r += 4)
        transpose_four(from, r, out + r);
#pragma GCC unroll 4
    for (int r = n / 4 * 4; r < n; r++) {
        double one[FMB_LANES];
#pragma GCC unroll 8
        for (int l = 0; l < FMB_LANES; l++)
            one[l] = from[l][r];
        out[r] = lane_load(one);
    }
}

/* x, y and z of FMB_LANES points of space, numbers of which stand in a row in `from`. */
FMB_INLINE void transpose_points(const lane from[3], lane out[3])
{
#if FMB_LANES == 1
    for (int k = 0; k < 3; k++)
        out[k] = from[k];
#else
    lane p = from[0], q = from[1], r = from[2]; /* (x y), (z x), (y z), each from the next points */
#if FMB_LANES == 8
    const lane a = from[0], b = from[1], c = from[2];
    p = _mm512_shuffle_f64x2(a, _mm512_shuffle_f64x2(b, c, 0x5a), 0x8c);
    q = _mm512_shuffle_f64x2(_mm512_shuffle_f64x2(a, b, 0x05), _mm512_shuffle_f64x2(b, c, 0xaf),
                             0x88);
    r = _mm512_shuffle_f64x2(_mm512_shuffle_f64x2(a, b, 0x5a), c, 0xc8);
#elif FMB_LANES == 4
    p = _mm256_permute2f128_pd(from[0], from[1], 0x30);
    q = _mm256_permute2f128_pd(from[0], from[2], 0x21);
    r = _mm256_permute2f128_pd(from[1], from[2], 0x30);
#endif
    enum { EVEN = (1 << FMB_LANES) / 3, ODD = (1 << FMB_LANES) - 1 - EVEN };
    out[0] = LANE(shuffle, p, q, ODD);
    out[1] = LANE(shuffle, p, r, EVEN);
    out[2] = LANE(shuffle, q, r, ODD);
#endif
}

#endif
