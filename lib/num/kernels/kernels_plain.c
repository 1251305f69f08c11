/* kernels_plain.c: the inner loops in C, for any processor; the others are held against these. */
#include "num/kernels/kernels.h"

/* Bits set, by sums of ever wider fields. Source: Knuth, TAOCP 4A, 7.1.3. */
static int count_bits_of_word(uint64_t x)
{
    x -= (x >> 1) & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + ((x >> 2) & 0x3333333333333333u);
    x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return (int)((x * 0x0101010101010101u) >> 56);
}

static void mark_larger_unions_plain(const fmb_planes *p, const uint64_t *a, int most,
                                     uint64_t *drop)
{
    for (size_t j = 0; j < p->count; j++) {
        int size = 0;
        for (size_t k = 0; k < p->words; k++)
            size += count_bits_of_word(a[k] | p->bits[k * p->stride + j]);
        drop[j / 64] |= (uint64_t)(size > most) << (j % 64);
    }
}

static size_t count_sets_inside_plain(const fmb_planes *p, const uint64_t *u, size_t enough)
{
    size_t found = 0;
    for (size_t j = 0; j < p->count && found < enough; j++) {
        uint64_t outside = 0;
        for (size_t k = 0; k < p->words; k++)
            outside |= p->bits[k * p->stride + j] & ~u[k];
        found += outside == 0;
    }
    return found;
}

static uint64_t combine_words_plain(int64_t *dst, const int64_t *a, const int64_t *b, size_t n,
                                    int64_t p, int64_t q)
{
    uint64_t all = 0;
    for (size_t i = 0; i < n; i++) {
        dst[i] = p * a[i] + q * b[i];
        all |= dst[i] < 0 ? 0 - (uint64_t)dst[i] : (uint64_t)dst[i];
    }
    return all;
}

static void add_multiple_plain(double *out, const double *x, size_t n, double y)
{
    for (size_t i = 0; i < n; i++)
        out[i] += y * x[i];
}

const fmb_kernels fmb_kernels_plain = {mark_larger_unions_plain, count_sets_inside_plain,
                                       combine_words_plain, combine_words_plain,
                                       add_multiple_plain};
