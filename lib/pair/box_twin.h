/* box_twin.h: numbers of once or twice the precision of a double.
 *
 * A twin is the sum hi + lo, |lo| <= 2^-53 |hi|. Every function takes a constant `fine`: if false,
 * lo is 0, is never looked at, and the function is the one operation on hi. With
 *
 *     unit = BOX_UNIT(fine) = 2^-53, or 2^-102 = 16 u^2 if fine (u = 2^-53),
 *
 * the errors are at most unit (|a| + |b|) for twin_add, unit |ab| for twin_times, and 4 unit |a/b|
 * for twin_over. Proof for fine ones. Sum: hi + rest is the exact sum of the his; al + bl is off by
 * u^2 (|a| + |b|), adding it to rest by 2 u^2 (|a| + |b|), and the last step is exact. Product: the
 * error of the product of the his is known exactly (e); al bh + ah bl is off by 4 u^2 |ab|, al bl
 * is left out (u^2), e plus them is off by 3 u^2 |ab|. Quotient: q = a.hi * r is off by less than
 * 4 u |a/b|; what is left, a - q b, is off by at most 2.1 unit |a|, and a correction of at most
 * 4 u |a/b| is itself off by 5 u of it: less than 4 unit |a/b| in all.
 *
 * Source: Dekker 1971.
 */
#ifndef FMB_PAIR_BOX_TWIN_H
#define FMB_PAIR_BOX_TWIN_H

#include <fmb/frame.h>

#include "pair/lane.h"

#define BOX_UNIT(fine) ((fine) ? 0x1p-102 : 0x1p-53)

typedef struct twin {
    lane hi, lo;
} twin;

FMB_INLINE twin twin_of(lane a)
{
    return (twin){a, lane_of(0)};
}

FMB_INLINE twin twin_minus(twin a)
{
    return (twin){-a.hi, -a.lo};
}

/* a + b, exactly */
FMB_INLINE twin twin_sum(lane a, lane b)
{
    lane s = a + b;
    lane of_b = s - a;
    lane of_a = s - of_b;
    return (twin){s, (a - of_a) + (b - of_b)};
}

#if FMB_LANES == 8 || FMB_LANES == 4
/* ab, exactly (but for underflow) */
FMB_INLINE twin twin_product(lane a, lane b)
{
    lane p = a * b;
    return (twin){p, lane_fms(a, b, p)};
}
#else
/* The upper 26 bits of a. */
FMB_INLINE lane twin_upper(lane a)
{
    lane c = lane_of(0x1p27 + 1) * a;
    lane low = c - a;
    return c - low;
}
FMB_INLINE twin twin_product(lane a, lane b)
{
    lane p = a * b;
    lane ah = twin_upper(a), bh = twin_upper(b);
    lane al = a - ah, bl = b - bh;
    lane e = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
    return (twin){p, e};
}
#endif

FMB_INLINE twin twin_add(bool fine, twin a, twin b)
{
    if (!fine)
        return twin_of(a.hi + b.hi);
    twin s = twin_sum(a.hi, b.hi);
    return twin_sum(s.hi, s.lo + (a.lo + b.lo));
}

FMB_INLINE twin twin_subtract(bool fine, twin a, twin b)
{
    return twin_add(fine, a, twin_minus(b));
}

FMB_INLINE twin twin_times(bool fine, twin a, twin b)
{
    if (!fine)
        return twin_of(a.hi * b.hi);
    twin p = twin_product(a.hi, b.hi);
    return twin_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* a / b, given r = 1 / b.hi */
FMB_INLINE twin twin_over(bool fine, twin a, twin b, lane r)
{
    lane q = a.hi * r;
    if (!fine)
        return twin_of(q);
    twin left = twin_subtract(fine, a, twin_times(fine, twin_of(q), b));
    return twin_sum(q, left.hi * r);
}

/* A number of the sign of a - b: the difference of the his is exact where the los matter. */
FMB_INLINE lane twin_compare(bool fine, twin a, twin b)
{
    return fine ? (a.hi - b.hi) + (a.lo - b.lo) : a.hi - b.hi;
}

FMB_INLINE twin twin_pick(bool fine, lane_mask m, twin yes, twin no)
{
    twin t = {lane_pick(m, yes.hi, no.hi), no.lo};
    if (fine)
        t.lo = lane_pick(m, yes.lo, no.lo);
    return t;
}

FMB_INLINE twin twin_min(bool fine, twin a, twin b)
{
    if (!fine)
        return twin_of(lane_min(a.hi, b.hi));
    return twin_pick(fine, lane_less(twin_compare(fine, a, b), lane_of(0)), a, b);
}

FMB_INLINE twin twin_max(bool fine, twin a, twin b)
{
    if (!fine)
        return twin_of(lane_max(a.hi, b.hi));
    return twin_pick(fine, lane_less(twin_compare(fine, a, b), lane_of(0)), b, a);
}

/* With the sign of s (of a, if s > 0 there). */
FMB_INLINE twin twin_times_sign(bool fine, twin a, lane s)
{
    return (twin){lane_times_sign(a.hi, s), fine ? lane_times_sign(a.lo, s) : a.lo};
}

#endif
