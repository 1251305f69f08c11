/* lane.h: vectors of numbers, one from each of several pairs.
 *
 * The kernels are written once, in terms of `lane`: FMB_LANES doubles, one of each pair of a block.
 * kernels_*.c set FMB_LANES to 4 (AVX2 with FMA) or 8 (AVX-512 F and DQ) and are compiled for those
 * instructions; every processor has 2 (SSE2) or 1, C alone, which a test wants. The operators + - *
 * / work on lanes, each rounded once; where FMB_LANE_FUSED, products in sums are not rounded
 * (docs/error-bounds.md, "The calculus"). min and max are for numbers only: no NaN may get there,
 * but as box_hull.h says.
 */
#ifndef FMB_PAIR_LANE_H
#define FMB_PAIR_LANE_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef FMB_LANES
#if defined __SSE2__ && !defined FMB_LANE_PLAIN
#define FMB_LANES 2
#else
#define FMB_LANES 1
#endif
#endif

#define FMB_INLINE static inline __attribute__((always_inline, unused))

/* FMB_BOX_INLINE: before functions of boxes. FMB_UNROLL: before a short loop with constant bounds,
 * which unrolling removes. A kernel of boxes as one function takes clang minutes (gcc seconds). */
#ifdef __clang__
#define FMB_BOX_INLINE static inline __attribute__((unused))
#define FMB_UNROLL
#define FMB_NEVER_CLONED __attribute__((noinline))
#else
#define FMB_BOX_INLINE   FMB_INLINE
#define FMB_UNROLL       _Pragma("GCC unroll 16")
#define FMB_NEVER_CLONED __attribute__((noinline, noclone))
#endif

/* Are products fused with sums, so that they are not rounded? */
#define FMB_LANE_FUSED (FMB_LANES == 8 || FMB_LANES == 4)

#if FMB_LANES == 8
#include <immintrin.h>
typedef __m512d lane;
typedef __mmask8 lane_mask; /* a bit of each lane */
#define LANE(name, ...) _mm512_##name##_pd(__VA_ARGS__)
#define LANE_TERNARY(a, b, c, table)                                                               \
    _mm512_castsi512_pd(_mm512_ternarylogic_epi64(_mm512_castpd_si512(a), _mm512_castpd_si512(b),  \
                                                  _mm512_castpd_si512(c), table))
FMB_INLINE lane_mask lane_less(lane a, lane b)
{
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
FMB_INLINE lane lane_pick(lane_mask m, lane yes, lane no)
{
    return _mm512_mask_blend_pd(m, no, yes);
}
FMB_INLINE unsigned lane_bits(lane_mask m)
{
    return m;
}
FMB_INLINE lane lane_abs(lane a)
{
    return _mm512_abs_pd(a);
}
/* a, or -a where s is negative */
FMB_INLINE lane lane_times_sign(lane a, lane s)
{
    return LANE_TERNARY(a, s, _mm512_set1_pd(-0.0), 0x78); /* a ^ (s & sign) */
}
/* The mask of lanes whose sign bit is set. */
FMB_INLINE lane_mask lane_negative(lane a)
{
    return _mm512_movepi64_mask(_mm512_castpd_si512(a));
}
/* a > 0 and |b|: the larger, the smaller. (Without optimisation these are macros of gcc's header,
 * which warns of itself.) */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"
FMB_INLINE lane lane_max_abs(lane a, lane b)
{
    return _mm512_range_pd(a, b, 11);
}
FMB_INLINE lane lane_min_abs(lane a, lane b)
{
    return _mm512_range_pd(a, b, 10);
}
#pragma GCC diagnostic pop
/* max(a, b) where m, else a */
FMB_INLINE lane lane_max_where(lane_mask m, lane a, lane b)
{
    return _mm512_mask_max_pd(a, m, a, b);
}
/* a, whose bit `place` is 0, with the sign bit of b there. */
FMB_INLINE lane lane_with_sign(lane a, lane b, int place)
{
    const __m512i all = _mm512_srai_epi64(_mm512_castpd_si512(b), 63);
    return LANE_TERNARY(a, _mm512_castsi512_pd(all),
                        _mm512_castsi512_pd(_mm512_set1_epi64((int64_t)1 << place)), 0xf8);
}
#elif FMB_LANES == 4
#include <immintrin.h>
typedef __m256d lane;
typedef __m256d lane_mask; /* the sign bit of each lane */
#define LANE(name, ...) _mm256_##name##_pd(__VA_ARGS__)
FMB_INLINE lane_mask lane_less(lane a, lane b)
{
    return _mm256_cmp_pd(a, b, _CMP_LT_OQ);
}
FMB_INLINE lane lane_pick(lane_mask m, lane yes, lane no)
{
    return _mm256_blendv_pd(no, yes, m);
}
FMB_INLINE unsigned lane_bits(lane_mask m)
{
    return (unsigned)_mm256_movemask_pd(m);
}
FMB_INLINE lane lane_abs(lane a)
{
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}
FMB_INLINE lane lane_times_sign(lane a, lane s)
{
    return _mm256_xor_pd(a, _mm256_and_pd(s, _mm256_set1_pd(-0.0)));
}
/* Only sign bits of masks are ever used. */
FMB_INLINE lane_mask lane_negative(lane a)
{
    return a;
}
#elif FMB_LANES == 2
#include <emmintrin.h>
typedef __m128d lane;
typedef __m128d lane_mask;
#define LANE(name, ...) _mm_##name##_pd(__VA_ARGS__)
FMB_INLINE lane_mask lane_less(lane a, lane b)
{
    return _mm_cmplt_pd(a, b);
}
FMB_INLINE lane lane_pick(lane_mask m, lane yes, lane no)
{
    return _mm_or_pd(_mm_and_pd(m, yes), _mm_andnot_pd(m, no));
}
FMB_INLINE unsigned lane_bits(lane_mask m)
{
    return (unsigned)_mm_movemask_pd(m);
}
FMB_INLINE lane lane_abs(lane a)
{
    return _mm_andnot_pd(_mm_set1_pd(-0.0), a);
}
FMB_INLINE lane lane_times_sign(lane a, lane s)
{
    return _mm_xor_pd(a, _mm_and_pd(s, _mm_set1_pd(-0.0)));
}
FMB_INLINE lane_mask lane_negative(lane a)
{
    __m128i high = _mm_srai_epi32(_mm_castpd_si128(a), 31);
    return _mm_castsi128_pd(_mm_shuffle_epi32(high, 0xf5));
}
#else
typedef double lane;
typedef unsigned lane_mask;
FMB_INLINE lane_mask lane_less(lane a, lane b)
{
    return a < b;
}
FMB_INLINE lane lane_pick(lane_mask m, lane yes, lane no)
{
    return m ? yes : no;
}
FMB_INLINE unsigned lane_bits(lane_mask m)
{
    return m;
}
FMB_INLINE lane lane_abs(lane a)
{
    return fabs(a);
}
FMB_INLINE lane lane_times_sign(lane a, lane s)
{
    return signbit(s) ? -a : a;
}
FMB_INLINE lane_mask lane_negative(lane a)
{
    return signbit(a) != 0;
}
#endif

#if FMB_LANES > 1
FMB_INLINE lane lane_of(double a)
{
    return LANE(set1, a);
}
FMB_INLINE lane lane_load(const double *a)
{
    return LANE(loadu, a);
}
FMB_INLINE void lane_store(double *a, lane x)
{
    LANE(storeu, a, x);
}
FMB_INLINE lane lane_min(lane a, lane b)
{
    return LANE(min, a, b);
}
FMB_INLINE lane lane_max(lane a, lane b)
{
    return LANE(max, a, b);
}
#else
FMB_INLINE lane lane_of(double a)
{
    return a;
}
FMB_INLINE lane lane_load(const double *a)
{
    return *a;
}
FMB_INLINE void lane_store(double *a, lane x)
{
    *a = x;
}
FMB_INLINE lane lane_min(lane a, lane b)
{
    return a < b ? a : b;
}
FMB_INLINE lane lane_max(lane a, lane b)
{
    return a > b ? a : b;
}
#endif

/* The largest of all lanes, in each lane. */
FMB_INLINE lane lane_largest(lane a)
{
#if FMB_LANES == 8
    a = lane_max(a, _mm512_shuffle_f64x2(a, a, 0x4e));
    a = lane_max(a, _mm512_permutex_pd(a, 0x4e));
    a = lane_max(a, _mm512_permute_pd(a, 0x55));
#elif FMB_LANES == 4
    a = lane_max(a, _mm256_permute2f128_pd(a, a, 1));
    a = lane_max(a, _mm256_permute_pd(a, 5));
#elif FMB_LANES == 2
    a = lane_max(a, _mm_shuffle_pd(a, a, 1));
#endif
    return a;
}

/* The first n numbers at a, and 0 in the other lanes; n may be less than 0 or too large. */
FMB_INLINE lane lane_load_some(const double *a, int n)
{
#if FMB_LANES == 8
    return _mm512_maskz_loadu_pd((__mmask8)(n <= 0 ? 0 : n >= 8 ? 0xff : (1 << n) - 1), a);
#else
    double some[FMB_LANES] = {0};
    for (int l = 0; l < FMB_LANES && l < n; l++)
        some[l] = a[l];
    return n >= FMB_LANES ? lane_load(a) : lane_load(some);
#endif
}

/* Lanes as words of 64 bits: shifted, and combined bit by bit. */
#if FMB_LANES > 1
typedef uint64_t lane_word __attribute__((vector_size(8 * FMB_LANES)));
#define LANE_WORD(a)    ((lane_word)(a))
#define LANE_OF_WORD(a) ((lane)(a))
#else
typedef uint64_t lane_word;
FMB_INLINE lane_word LANE_WORD(lane a)
{
    lane_word w;
    memcpy(&w, &a, sizeof w);
    return w;
}
FMB_INLINE lane LANE_OF_WORD(lane_word w)
{
    lane a;
    memcpy(&a, &w, sizeof a);
    return a;
}
#endif
#if FMB_LANES < 8
#define LANE_TERNARY(a, b, c, table) LANE_BY_WORDS_##table(LANE_WORD(a), LANE_WORD(b), LANE_WORD(c))
#define LANE_BY_WORDS_0xf6(a, b, c)  LANE_OF_WORD((a) | ((b) ^ (c)))
#define LANE_BY_WORDS_0xf9(a, b, c)  LANE_OF_WORD((a) | ~((b) ^ (c)))
#define LANE_BY_WORDS_0x96(a, b, c)  LANE_OF_WORD((a) ^ (b) ^ (c))
#define LANE_BY_WORDS_0xf8(a, b, c)  LANE_OF_WORD((a) | ((b) & (c)))
#define LANE_BY_WORDS_0xf4(a, b, c)  LANE_OF_WORD((a) | ((b) & ~(c)))
#endif
FMB_INLINE lane lane_of_bits(uint64_t a)
{
    double x;
    memcpy(&x, &a, sizeof x);
    return lane_of(x);
}
FMB_INLINE lane lane_shift_right(lane a, int by)
{
    return LANE_OF_WORD(LANE_WORD(a) >> by);
}
FMB_INLINE lane lane_or_xor(lane a, lane b, lane c)
{
    return LANE_TERNARY(a, b, c, 0xf6);
}
FMB_INLINE lane lane_or_same(lane a, lane b, lane c) /* where b and c are the same */
{
    return LANE_TERNARY(a, b, c, 0xf9);
}
FMB_INLINE lane lane_xor_xor(lane a, lane b, lane c)
{
    return LANE_TERNARY(a, b, c, 0x96);
}
FMB_INLINE lane lane_or_and(lane a, lane b, lane c)
{
    return LANE_TERNARY(a, b, c, 0xf8);
}
FMB_INLINE lane lane_or_and_not(lane a, lane b, lane c)
{
    return LANE_TERNARY(a, b, c, 0xf4);
}
/* Negative where any bit is set. */
FMB_INLINE lane lane_any_bit(lane a)
{
    return LANE_OF_WORD(LANE_WORD(a) | -LANE_WORD(a));
}

#if FMB_LANES < 8
FMB_INLINE lane lane_max_abs(lane a, lane b)
{
    return lane_max(a, lane_abs(b));
}
FMB_INLINE lane lane_min_abs(lane a, lane b)
{
    return lane_min(a, lane_abs(b));
}
FMB_INLINE lane lane_max_where(lane_mask m, lane a, lane b)
{
    return lane_max(a, lane_pick(m, b, a));
}
FMB_INLINE lane lane_with_sign(lane a, lane b, int place)
{
    return LANE_OF_WORD(LANE_WORD(a) | (LANE_WORD(b) >> 63) << place);
}
#endif

/* ab + c, ab - c, c - ab and -ab - c, rounded once or twice. */
#if FMB_LANE_FUSED
FMB_INLINE lane lane_fma(lane a, lane b, lane c)
{
    return LANE(fmadd, a, b, c);
}
FMB_INLINE lane lane_fms(lane a, lane b, lane c)
{
    return LANE(fmsub, a, b, c);
}
FMB_INLINE lane lane_fnma(lane a, lane b, lane c)
{
    return LANE(fnmadd, a, b, c);
}
FMB_INLINE lane lane_fnms(lane a, lane b, lane c)
{
    return LANE(fnmsub, a, b, c);
}
#else
FMB_INLINE lane lane_fma(lane a, lane b, lane c)
{
    return a * b + c;
}
FMB_INLINE lane lane_fms(lane a, lane b, lane c)
{
    return a * b - c;
}
FMB_INLINE lane lane_fnma(lane a, lane b, lane c)
{
    return c - a * b;
}
FMB_INLINE lane lane_fnms(lane a, lane b, lane c)
{
    return -(a * b) - c;
}
#endif

#if FMB_LANES == 8
FMB_INLINE lane_mask lane_and(lane_mask a, lane_mask b)
{
    return a & b;
}
FMB_INLINE lane_mask lane_or(lane_mask a, lane_mask b)
{
    return a | b;
}
#elif FMB_LANES > 1
FMB_INLINE lane_mask lane_and(lane_mask a, lane_mask b)
{
    return LANE(and, a, b);
}
FMB_INLINE lane_mask lane_or(lane_mask a, lane_mask b)
{
    return LANE(or, a, b);
}
#else
FMB_INLINE lane_mask lane_and(lane_mask a, lane_mask b)
{
    return a & b;
}
FMB_INLINE lane_mask lane_or(lane_mask a, lane_mask b)
{
    return a | b;
}
#endif

#endif
