/* split_double.h: a double as an integer times a power of two. */
#ifndef FMB_NUM_SPLIT_DOUBLE_H
#define FMB_NUM_SPLIT_DOUBLE_H

#include <stdint.h>
#include <string.h>

/* |x| = m 2^e, m odd or 0. */
static inline uint64_t fmb_split_double(double x, int *e)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    uint64_t m = bits & ((UINT64_C(1) << 52) - 1);
    int exponent = (int)(bits >> 52 & 0x7ff);
    m |= (uint64_t)(exponent > 0) << 52;
    int zeros = m == 0 ? 0 : __builtin_ctzll(m);
    *e = (exponent > 0 ? exponent : 1) - 1075 + zeros;
    return m >> zeros;
}

#endif
