/* kernels_avx2.c: the inner loops four words at a time. */
#include "num/kernels/kernels.h"

#ifdef FMB_HAVE_X86
#include <immintrin.h>

#define AVX2 __attribute__((target("avx2")))

/* Four words. Unaligned, as sets may begin at any word. */
AVX2 static inline __m256i load_avx2(const void *p)
{
    return _mm256_loadu_si256(p);
}

/* Bits set in each word: by halves of bytes from a table, then summed. Source: Mula 2008. */
AVX2 static inline __m256i count_bits(__m256i x)
{
    const __m256i table = _mm256_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4, 0, 1, 1,
                                           2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4);
    const __m256i half = _mm256_set1_epi8(15);
    __m256i low = _mm256_and_si256(x, half);
    __m256i high = _mm256_and_si256(_mm256_srli_epi16(x, 4), half);
    __m256i bytes =
        _mm256_add_epi8(_mm256_shuffle_epi8(table, low), _mm256_shuffle_epi8(table, high));
    return _mm256_sad_epu8(bytes, _mm256_setzero_si256());
}

/* One bit for each word of x that is all ones. */
AVX2 static inline unsigned sign_bits(__m256i x)
{
    return (unsigned)_mm256_movemask_pd(_mm256_castsi256_pd(x));
}

AVX2 static void mark_larger_unions_avx2(const fmb_planes *p, const uint64_t *a, int most,
                                         uint64_t *drop)
{
    const __m256i bound = _mm256_set1_epi64x(most);
    for (size_t j = 0; j < p->count; j += 4) {
        __m256i size = _mm256_setzero_si256();
        for (size_t k = 0; k < p->words; k++) {
            __m256i set = load_avx2(&p->bits[k * p->stride + j]);
            __m256i both = _mm256_or_si256(set, _mm256_set1_epi64x((long long)a[k]));
            size = _mm256_add_epi64(size, count_bits(both));
        }
        unsigned mask = sign_bits(_mm256_cmpgt_epi64(size, bound));
        if (p->count - j < 4)
            mask &= (1u << (p->count - j)) - 1;
        drop[j / 64] |= (uint64_t)mask << (j % 64);
    }
}

AVX2 static size_t count_sets_inside_avx2(const fmb_planes *p, const uint64_t *u, size_t enough)
{
    const __m256i zero = _mm256_setzero_si256();
    size_t found = 0;
    for (size_t j = 0; j < p->count && found < enough; j += 4) {
        __m256i outside = zero;
        for (size_t k = 0; k < p->words; k++) {
            __m256i set = load_avx2(&p->bits[k * p->stride + j]);
            __m256i over = _mm256_andnot_si256(_mm256_set1_epi64x((long long)u[k]), set);
            outside = _mm256_or_si256(outside, over);
        }
        unsigned mask = sign_bits(_mm256_cmpeq_epi64(outside, zero));
        if (p->count - j < 4)
            mask &= (1u << (p->count - j)) - 1;
        found += (size_t)__builtin_popcount(mask);
    }
    return found;
}

AVX2 static inline __m256i absolute(__m256i x)
{
    __m256i sign = _mm256_cmpgt_epi64(_mm256_setzero_si256(), x);
    return _mm256_sub_epi64(_mm256_xor_si256(x, sign), sign);
}

static inline uint64_t absolute_of_word(int64_t x)
{
    return x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
}

AVX2 static inline uint64_t join(__m256i all)
{
    __m128i two = _mm_or_si128(_mm256_castsi256_si128(all), _mm256_extracti128_si256(all, 1));
    return (uint64_t)_mm_cvtsi128_si64(two) | (uint64_t)_mm_extract_epi64(two, 1);
}

/* AVX2 has no product of 64 bits, only one of the low halves. */
AVX2 static uint64_t combine_narrow_words_avx2(int64_t *dst, const int64_t *a, const int64_t *b,
                                               size_t n, int64_t p, int64_t q)
{
    const __m256i vp = _mm256_set1_epi64x(p), vq = _mm256_set1_epi64x(q);
    __m256i all = _mm256_setzero_si256();
    uint64_t rest = 0;
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        __m256i x = _mm256_mul_epi32(load_avx2(&a[i]), vp),
                y = _mm256_mul_epi32(load_avx2(&b[i]), vq);
        __m256i sum = _mm256_add_epi64(x, y);
        _mm256_storeu_si256((__m256i *)(void *)&dst[i], sum);
        all = _mm256_or_si256(all, absolute(sum));
    }
    for (; i < n; i++) {
        dst[i] = p * a[i] + q * b[i];
        rest |= absolute_of_word(dst[i]);
    }
    return join(all) | rest;
}

/* The compiler does as well from the plain text. */
AVX2 static uint64_t combine_words_avx2(int64_t *dst, const int64_t *a, const int64_t *b, size_t n,
                                        int64_t p, int64_t q)
{
    uint64_t all = 0;
    for (size_t i = 0; i < n; i++) {
        dst[i] = p * a[i] + q * b[i];
        all |= absolute_of_word(dst[i]);
    }
    return all;
}

AVX2 static void add_multiple_avx2(double *out, const double *x, size_t n, double y)
{
    const __m256d vy = _mm256_set1_pd(y);
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        __m256d product = _mm256_mul_pd(vy, _mm256_loadu_pd(&x[i]));
        _mm256_storeu_pd(&out[i], _mm256_add_pd(_mm256_loadu_pd(&out[i]), product));
    }
    for (; i < n; i++)
        out[i] += y * x[i];
}

const fmb_kernels fmb_kernels_avx2 = {mark_larger_unions_avx2, count_sets_inside_avx2,
                                      combine_words_avx2, combine_narrow_words_avx2,
                                      add_multiple_avx2};
#else
typedef int fmb_no_avx2;
#endif
