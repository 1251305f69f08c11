/* error_free.h: sums and products of two doubles without an error, as a pair of doubles.
 *
 * Sources: Knuth, The Art of Computer Programming 2, 4.2.2 (sum); Veltkamp and Dekker 1971
 * (product).
 */
#ifndef FMB_PAIR_ERROR_FREE_H
#define FMB_PAIR_ERROR_FREE_H

#include "pair/kernels/lane/lane.h"

typedef struct lane2 {
    lane hi, lo;
} lane2;

/* a + b, exactly */
FMB_INLINE lane2 two_sum(lane a, lane b)
{
    lane s = a + b;
    lane of_b = s - a;
    lane of_a = s - of_b;
    return (lane2){s, (a - of_a) + (b - of_b)};
}

#if FMB_LANES == 8 || FMB_LANES == 4
/* ab, exactly (but for underflow) */
FMB_INLINE lane2 two_product(lane a, lane b)
{
    lane p = a * b;
    return (lane2){p, lane_fms(a, b, p)};
}
#else
/* The upper 26 bits of a. */
FMB_INLINE lane upper_half(lane a)
{
    lane c = lane_of(0x1p27 + 1) * a;
    lane low = c - a;
    return c - low;
}
FMB_INLINE lane2 two_product(lane a, lane b)
{
    lane p = a * b;
    lane ah = upper_half(a), bh = upper_half(b);
    lane al = a - ah, bl = b - bh;
    lane e = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
    return (lane2){p, e};
}
#endif

#endif
