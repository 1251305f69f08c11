/* double_double.h: numbers of once or twice the precision of a double.
 *
 * A lane2 is the sum hi + lo, |lo| <= 2^-53 |hi|. Every function takes a constant `fine`: if false,
 * lo is 0, is never looked at, and the function is the one operation on hi. Errors are counted in
 * units LANE2_UNIT: docs/error-bounds.md, "Double-doubles".
 *
 * Source: Dekker, A floating-point technique for extending the available precision, 1971.
 */
#ifndef FMB_PAIR_DOUBLE_DOUBLE_H
#define FMB_PAIR_DOUBLE_DOUBLE_H

#include <fmb/frame.h>

#include "pair/kernels/lane/error_free.h"

#define LANE2_UNIT(fine) ((fine) ? 0x1p-102 : 0x1p-53)

FMB_INLINE lane2 lane2_of(lane a)
{
    return (lane2){a, lane_of(0)};
}

FMB_INLINE lane2 lane2_minus(lane2 a)
{
    return (lane2){-a.hi, -a.lo};
}

FMB_INLINE lane2 lane2_add(bool fine, lane2 a, lane2 b)
{
    if (!fine)
        return lane2_of(a.hi + b.hi);
    lane2 s = two_sum(a.hi, b.hi);
    return two_sum(s.hi, s.lo + (a.lo + b.lo));
}

FMB_INLINE lane2 lane2_subtract(bool fine, lane2 a, lane2 b)
{
    return lane2_add(fine, a, lane2_minus(b));
}

FMB_INLINE lane2 lane2_times(bool fine, lane2 a, lane2 b)
{
    if (!fine)
        return lane2_of(a.hi * b.hi);
    lane2 p = two_product(a.hi, b.hi);
    return two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* a / b, given r = 1 / b.hi */
FMB_INLINE lane2 lane2_over(bool fine, lane2 a, lane2 b, lane r)
{
    lane q = a.hi * r;
    if (!fine)
        return lane2_of(q);
    lane2 left = lane2_subtract(fine, a, lane2_times(fine, lane2_of(q), b));
    return two_sum(q, left.hi * r);
}

/* A number of the sign of a - b: the difference of the his is exact where the los matter. */
FMB_INLINE lane lane2_compare(bool fine, lane2 a, lane2 b)
{
    return fine ? (a.hi - b.hi) + (a.lo - b.lo) : a.hi - b.hi;
}

FMB_INLINE lane2 lane2_pick(bool fine, lane_mask m, lane2 yes, lane2 no)
{
    lane2 t = {lane_pick(m, yes.hi, no.hi), no.lo};
    if (fine)
        t.lo = lane_pick(m, yes.lo, no.lo);
    return t;
}

FMB_INLINE lane2 lane2_min(bool fine, lane2 a, lane2 b)
{
    if (!fine)
        return lane2_of(lane_min(a.hi, b.hi));
    return lane2_pick(fine, lane_less(lane2_compare(fine, a, b), lane_of(0)), a, b);
}

FMB_INLINE lane2 lane2_max(bool fine, lane2 a, lane2 b)
{
    if (!fine)
        return lane2_of(lane_max(a.hi, b.hi));
    return lane2_pick(fine, lane_less(lane2_compare(fine, a, b), lane_of(0)), b, a);
}

/* With the sign of s (of a, if s > 0 there). */
FMB_INLINE lane2 lane2_times_sign(bool fine, lane2 a, lane s)
{
    return (lane2){lane_times_sign(a.hi, s), fine ? lane_times_sign(a.lo, s) : a.lo};
}

#endif
