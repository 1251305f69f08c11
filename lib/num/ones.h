/* ones.h: how many bits of a word are 1. For processors at large a compiler knows no instruction
 * for that, and calls a function. Source: Warren 2012, Hacker's Delight, 5-1.
 */
#ifndef FMB_NUM_ONES_H
#define FMB_NUM_ONES_H

#include <stdint.h>

static inline unsigned fmb_ones64(uint64_t x)
{
    x -= x >> 1 & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + (x >> 2 & 0x3333333333333333u);
    x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return (unsigned)(x * 0x0101010101010101u >> 56);
}

#endif
