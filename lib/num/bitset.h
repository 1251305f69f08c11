/* bitset.h: sets of small numbers, a bit each in words of 64. */
#ifndef FMB_NUM_BITSET_H
#define FMB_NUM_BITSET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The number of bits of x that are 1. On a generic x86-64 target __builtin_popcountll would be a
 * function call. Source: Warren 2012, Hacker's Delight, 5-1. */
static inline unsigned fmb_ones64(uint64_t x)
{
    x -= x >> 1 & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + (x >> 2 & 0x3333333333333333u);
    x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return (unsigned)(x * 0x0101010101010101u >> 56);
}

/* Words for a set of numbers below n. */
static inline size_t fmb_set_words(size_t n)
{
    return (n + 63) / 64;
}

static inline void fmb_set_put(uint64_t *set, size_t i)
{
    set[i / 64] |= (uint64_t)1 << i % 64;
}

static inline bool fmb_set_has(const uint64_t *set, size_t i)
{
    return set[i / 64] >> i % 64 & 1;
}

static inline size_t fmb_set_size(const uint64_t *set, size_t words)
{
    size_t n = 0;
    for (size_t k = 0; k < words; k++)
        n += fmb_ones64(set[k]);
    return n;
}

/* Is all of a in b? */
static inline bool fmb_set_is_inside(const uint64_t *a, const uint64_t *b, size_t words)
{
    for (size_t k = 0; k < words; k++)
        if (a[k] & ~b[k])
            return false;
    return true;
}

/* Is the intersection of a and b nonempty? */
static inline bool fmb_sets_meet(const uint64_t *a, const uint64_t *b, size_t words)
{
    for (size_t k = 0; k < words; k++)
        if (a[k] & b[k])
            return true;
    return false;
}

#endif
