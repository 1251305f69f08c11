/* kernels_avx512.c: the inner loops eight words at a time, with an instruction that counts bits. */
#include "num/kernels/kernels.h"

#ifdef FMB_HAVE_X86
#include <immintrin.h>

#define AVX512 __attribute__((target("avx512f,avx512dq,avx512vpopcntdq")))

/* The lanes of words j to j + 7 that are below count. */
AVX512 static inline __mmask8 lanes(size_t count, size_t j)
{
    return (__mmask8)(count - j >= 8 ? 0xffu : (1u << (count - j)) - 1);
}

AVX512 static inline __m512i load_avx512(const void *p)
{
    return _mm512_loadu_si512(p);
}

AVX512 static void mark_larger_unions_avx512(const fmb_planes *p, const uint64_t *a, int most,
                                             uint64_t *drop)
{
    const __m512i bound = _mm512_set1_epi64(most);
    for (size_t j = 0; j < p->count; j += 8) {
        __m512i size = _mm512_setzero_si512();
        for (size_t k = 0; k < p->words; k++) {
            __m512i set = load_avx512(&p->bits[k * p->stride + j]);
            __m512i both = _mm512_or_si512(set, _mm512_set1_epi64((long long)a[k]));
            size = _mm512_add_epi64(size, _mm512_popcnt_epi64(both));
        }
        uint64_t mask = _mm512_mask_cmpgt_epi64_mask(lanes(p->count, j), size, bound);
        drop[j / 64] |= mask << (j % 64);
    }
}

AVX512 static size_t count_sets_inside_avx512(const fmb_planes *p, const uint64_t *u, size_t enough)
{
    size_t found = 0;
    for (size_t j = 0; j < p->count && found < enough; j += 8) {
        __m512i outside = _mm512_setzero_si512();
        for (size_t k = 0; k < p->words; k++) {
            __m512i set = load_avx512(&p->bits[k * p->stride + j]);
            __m512i over = _mm512_andnot_si512(_mm512_set1_epi64((long long)u[k]), set);
            outside = _mm512_or_si512(outside, over);
        }
        __mmask8 mask = _mm512_mask_testn_epi64_mask(lanes(p->count, j), outside, outside);
        found += (size_t)__builtin_popcount(mask);
    }
    return found;
}

AVX512 static uint64_t combine_words_avx512(int64_t *dst, const int64_t *a, const int64_t *b,
                                            size_t n, int64_t p, int64_t q)
{
    const __m512i vp = _mm512_set1_epi64(p), vq = _mm512_set1_epi64(q);
    __m512i all = _mm512_setzero_si512();
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 m = lanes(n, i);
        __m512i x = _mm512_mullo_epi64(_mm512_maskz_loadu_epi64(m, &a[i]), vp);
        __m512i y = _mm512_mullo_epi64(_mm512_maskz_loadu_epi64(m, &b[i]), vq);
        __m512i sum = _mm512_add_epi64(x, y);
        _mm512_mask_storeu_epi64(&dst[i], m, sum);
        all = _mm512_or_si512(all, _mm512_abs_epi64(sum));
    }
    return (uint64_t)_mm512_reduce_or_epi64(all);
}

AVX512 static uint64_t combine_narrow_words_avx512(int64_t *dst, const int64_t *a, const int64_t *b,
                                                   size_t n, int64_t p, int64_t q)
{
    const __m512i vp = _mm512_set1_epi64(p), vq = _mm512_set1_epi64(q);
    __m512i all = _mm512_setzero_si512();
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 m = lanes(n, i);
        __m512i x = _mm512_mul_epi32(_mm512_maskz_loadu_epi64(m, &a[i]), vp);
        __m512i y = _mm512_mul_epi32(_mm512_maskz_loadu_epi64(m, &b[i]), vq);
        __m512i sum = _mm512_add_epi64(x, y);
        _mm512_mask_storeu_epi64(&dst[i], m, sum);
        all = _mm512_or_si512(all, _mm512_abs_epi64(sum));
    }
    return (uint64_t)_mm512_reduce_or_epi64(all);
}

/* A product and a sum, not fused, so that every level gives the same numbers. */
AVX512 static void add_multiple_avx512(double *out, const double *x, size_t n, double y)
{
    const __m512d vy = _mm512_set1_pd(y);
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 m = lanes(n, i);
        __m512d product = _mm512_mul_pd(vy, _mm512_maskz_loadu_pd(m, &x[i]));
        __m512d sum = _mm512_add_pd(_mm512_maskz_loadu_pd(m, &out[i]), product);
        _mm512_mask_storeu_pd(&out[i], m, sum);
    }
}

const fmb_kernels fmb_kernels_avx512 = {mark_larger_unions_avx512, count_sets_inside_avx512,
                                        combine_words_avx512, combine_narrow_words_avx512,
                                        add_multiple_avx512};
#else
typedef int fmb_no_avx512;
#endif
