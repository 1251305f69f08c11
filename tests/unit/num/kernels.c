/* kernels.c: every instruction set counts as a plain loop does, for any number of sets, words and
 * entries, up to the limits of the numbers. */
#include <criterion/criterion.h>
#include <string.h>

#include "num/bitset.h"
#include "num/int128.h"
#include "num/kernels/kernels.h"
#include "support.h"

enum { WORDS = 5, COUNT = 200, ROUNDS = 4000 };

static const fmb_kernels *level(int i)
{
    static const fmb_simd levels[] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};
    return fmb_kernels_choose(levels[i]);
}

Test(kernels, levels)
{
    cr_assert_not_null(level(0));
    const fmb_kernels *best = fmb_kernels_choose(FMB_SIMD_AUTO);
    for (int i = 0; i < 3; i++)
        if (!level(i))
            cr_log_info("no level %d on this processor", i);
        else
            best = best == level(i) ? NULL : best;
    cr_expect_null(best, "auto is one of the levels");
    cr_expect_null(fmb_kernels_choose((fmb_simd)99));
}

Test(kernels, ones_of_a_word)
{
    support_rng g = {1};
    for (int k = 0; k <= 64; k++) {
        cr_expect_eq(fmb_ones64(k < 64 ? ((uint64_t)1 << k) - 1 : UINT64_MAX), (unsigned)k);
        uint64_t word = support_next(&g);
        unsigned ones = 0;
        for (int bit = 0; bit < 64; bit++)
            ones += (unsigned)(word >> bit & 1);
        cr_expect_eq(fmb_ones64(word), ones);
    }
}

/* ---- sets ------------------------------------------------------------------------------------ */

typedef struct sets {
    fmb_planes p;
    uint64_t bits[WORDS * (COUNT + 8)], a[WORDS];
} sets;

/* Some bits of 100, or all. What lies between count and stride is no set, and full of bits. */
static void draw(sets *s, support_rng *g)
{
    int density = support_between(g, 0, 3);
    s->p = (fmb_planes){.bits = s->bits,
                        .words = (size_t)support_between(g, 1, WORDS),
                        .count = (size_t)support_between(g, 0, COUNT)};
    s->p.stride = (s->p.count + 7) / 8 * 8 + (support_chance(g, 20) ? 8 : 0);
    for (size_t k = 0; k < s->p.words; k++) {
        s->a[k] = density > 2 ? UINT64_MAX : support_next(g) | (density ? support_next(g) : 0);
        for (size_t j = 0; j < s->p.stride; j++) {
            uint64_t x = UINT64_MAX;
            for (int d = 0; j < s->p.count && d < density; d++)
                x &= support_next(g);
            s->bits[k * s->p.stride + j] = x;
        }
    }
}

static int size_together(const sets *s, size_t j)
{
    int n = 0;
    for (size_t k = 0; k < s->p.words; k++)
        for (int i = 0; i < 64; i++)
            n += (int)((s->a[k] | s->bits[k * s->p.stride + j]) >> i & 1);
    return n;
}

static bool is_inside(const sets *s, size_t j)
{
    for (size_t k = 0; k < s->p.words; k++)
        if (s->bits[k * s->p.stride + j] & ~s->a[k])
            return false;
    return true;
}

/* Bits set before stay, and none past the last set comes in. */
static void expect_larger(const fmb_kernels *k, const sets *s, support_rng *g)
{
    uint64_t drop[COUNT / 64 + 2], before[COUNT / 64 + 2];
    int most = support_between(g, 0, 64 * (int)s->p.words);
    for (size_t i = 0; i < COUNT / 64 + 2; i++)
        drop[i] = before[i] = support_next(g) & support_next(g);
    k->larger(&s->p, s->a, most, drop);
    for (size_t j = 0; j < 64 * (COUNT / 64 + 2); j++) {
        bool was = before[j / 64] >> (j % 64) & 1, is = drop[j / 64] >> (j % 64) & 1;
        bool larger = j < s->p.count && size_together(s, j) > most;
        cr_assert_eq(is, was || larger, "set %zu of %zu", j, s->p.count);
    }
}

static void expect_inside(const fmb_kernels *k, const sets *s, size_t enough)
{
    size_t all = 0;
    for (size_t j = 0; j < s->p.count; j++)
        all += is_inside(s, j);
    size_t found = k->inside(&s->p, s->a, enough);
    cr_assert_leq(found, all);
    cr_assert(found == all || (found >= enough && found < enough + 8), "%zu of %zu, %zu enough",
              found, all, enough);
}

Test(kernels, sets)
{
    static sets s;
    for (uint64_t seed = 0; seed < ROUNDS; seed++) {
        support_rng g = {seed};
        draw(&s, &g);
        for (int i = 0; i < 3; i++) {
            if (!level(i))
                continue;
            support_rng same = {seed};
            expect_larger(level(i), &s, &same);
            expect_inside(level(i), &s, SIZE_MAX / 2);
            expect_inside(level(i), &s, 3);
            expect_inside(level(i), &s, 0);
        }
    }
}

/* ---- combinations ---------------------------------------------------------------------------- */

/* Up to `most`, often just that. */
static int64_t draw_number(support_rng *g, int64_t most)
{
    int64_t x = support_chance(g, 30) ? most : (int64_t)(support_next(g) % ((uint64_t)most + 1));
    return support_chance(g, 50) ? -x : x;
}

typedef uint64_t combine(int64_t *dst, const int64_t *a, const int64_t *b, size_t n, int64_t p,
                         int64_t q);

/* Into a fresh place, and into a itself; nothing behind the last entry is touched. */
static void expect_combined(combine *f, const int64_t *a, const int64_t *b, size_t n, int64_t p,
                            int64_t q)
{
    int64_t fresh[COUNT + 8], own[COUNT + 8];
    uint64_t all = 0;
    memset(fresh, 0x5a, sizeof fresh);
    memset(own, 0x5a, sizeof own);
    memcpy(own, a, n * sizeof *a);
    uint64_t first = f(fresh, a, b, n, p, q), second = f(own, own, b, n, p, q);
    for (size_t i = 0; i < n; i++) {
        fmb_i128 x = fmb_i128_plus_product(fmb_i128_product(p, a[i]), q, b[i]);
        cr_assert(fmb_i128_compare(fmb_i128_of(fresh[i]), x) == 0 && own[i] == fresh[i],
                  "entry %zu of %zu", i, n);
        all |= fmb_u128_low(fmb_i128_size(x));
    }
    for (size_t i = n; i < COUNT + 8; i++)
        cr_assert(fresh[i] == 0x5a5a5a5a5a5a5a5a && own[i] == fresh[i]);
    cr_assert(first == all && second == all);
}

/* Factors and entries below 2^31. */
Test(kernels, combine_narrow)
{
    const int64_t most = INT32_MAX;
    int64_t a[COUNT], b[COUNT];
    for (uint64_t seed = 0; seed < ROUNDS; seed++) {
        support_rng g = {seed};
        size_t n = (size_t)support_between(&g, 0, seed % 2 ? COUNT : 20);
        for (size_t i = 0; i < n; i++) {
            a[i] = draw_number(&g, most);
            b[i] = draw_number(&g, most);
        }
        int64_t p = draw_number(&g, most), q = draw_number(&g, most);
        for (int i = 0; i < 3; i++)
            if (level(i))
                expect_combined(level(i)->combine_narrow, a, b, n, p, q);
    }
}

/* Results below 2^62, from entries and factors that together have that size. */
Test(kernels, combine)
{
    int64_t a[COUNT], b[COUNT];
    for (uint64_t seed = 0; seed < ROUNDS; seed++) {
        support_rng g = {seed};
        int bits = support_between(&g, 0, 61);
        size_t n = (size_t)support_between(&g, 0, seed % 2 ? COUNT : 20);
        int64_t factor = ((int64_t)1 << (61 - bits)) - (bits == 61 ? 0 : 1);
        int64_t entry = bits == 0 ? 1 : ((int64_t)1 << bits) - 1;
        for (size_t i = 0; i < n; i++) {
            a[i] = draw_number(&g, entry);
            b[i] = draw_number(&g, entry);
        }
        int64_t p = draw_number(&g, factor), q = draw_number(&g, factor);
        for (int i = 0; i < 3; i++)
            if (level(i))
                expect_combined(level(i)->combine, a, b, n, p, q);
    }
}

/* Both ends of what a word of a row may be. */
Test(kernels, combine_at_the_limit)
{
    const int64_t most = ((int64_t)1 << 62) - 1;
    const int64_t a[] = {most, -most, 1, 0, most, -most, -1, most, 5},
                  b[] = {most, -most, 1, most, 0, 0, most - 1, most - 2, -7}, zero[9] = {0};
    for (int i = 0; i < 3; i++) {
        if (!level(i))
            continue;
        for (size_t n = 0; n <= 9; n++) {
            expect_combined(level(i)->combine, a, zero, n, 1, most);
            expect_combined(level(i)->combine, zero, b, n, most, -1);
            expect_combined(level(i)->combine, a, b, n, 1, -1);
        }
    }
}
