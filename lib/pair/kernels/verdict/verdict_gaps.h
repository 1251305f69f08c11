/* verdict_gaps.h: the combined result of the rows of an elimination.
 *
 * The gap of a row, tested against A as a whole, is positive where it holds at no point of A. Rows
 * are in classes; the gaps of a class have one error bound, so only the largest of a class counts.
 *
 * Error bounds are those of docs/error-bounds.md, which counts them: S, E, H, V = most_size,
 * most_e, most_shift, most_drift bound the numbers of local_frame.h.
 */
#ifndef FMB_PAIR_VERDICT_GAPS_H
#define FMB_PAIR_VERDICT_GAPS_H

#include "pair/kernels/lane/local_frame.h"
#include "pair/kernels/packed_kernels.h"

/* What pairs a kernel is for; constant in each. */
typedef struct fmb_kind {
    int dim;
    bool moves, simplex; /* simplex: A is one (verdict_simplices.h) */
} fmb_kind;

typedef struct fmb_gaps {
    lane apart; /* largest gap - its error: positive means apart */
    lane meet;  /* largest gap + its error: negative means meet, if all rows were tested */
} fmb_gaps;

FMB_INLINE fmb_gaps fmb_gaps_none(void)
{
    return (fmb_gaps){lane_of(-INFINITY), lane_of(-INFINITY)};
}

/* count u bound */
FMB_INLINE lane fmb_gaps_error(double count, lane bound)
{
    return lane_of(count * 0x1p-53) * bound;
}

/* V as a factor: the drift may be so small that products with it underflow, so 2^-100 E more. Then
 * errors are above 2^-700, and what underflows is off by 2^-1075. */
FMB_INLINE lane fmb_gaps_speed(const local_frame *f)
{
    return lane_fma(lane_of(0x1p-100), f->most_e, f->most_drift);
}

/* Add a class whose largest gap has an error of at most count u bound. */
FMB_INLINE void fmb_gaps_class(fmb_gaps *x, lane gap, double count, lane bound)
{
    lane error = fmb_gaps_error(count, bound);
    x->apart = lane_max(x->apart, gap - error);
    x->meet = lane_max(x->meet, gap + error);
}

/* The first class there is. */
FMB_INLINE fmb_gaps fmb_gaps_first(lane gap, double count, lane bound)
{
    lane error = fmb_gaps_error(count, bound);
    return (fmb_gaps){gap - error, gap + error};
}

/* The largest of gaps 0 ... i of a class, given that of those before. Numbers are constant where
 * loops are unrolled, and nothing is asked about the first. */
FMB_INLINE lane fmb_gaps_largest(int i, lane before, lane gap)
{
    return i == 0 ? gap : lane_max(before, gap);
}

/* Let lanes meet only if a number of that size exceeds its error: then its sign is certain. */
FMB_INLINE void fmb_gaps_certain(fmb_gaps *x, lane size, double count, lane bound)
{
    x->meet = lane_max(x->meet, fmb_gaps_error(count, bound) - size);
}

/* Are all lanes apart already? Then no other row needs to be tested. */
FMB_INLINE bool fmb_gaps_done(const fmb_gaps *x, lane_mask known, fmb_pair_bits *out)
{
    const unsigned all = (1U << FMB_LANES) - 1;
    out->apart = lane_bits(lane_and(known, lane_less(lane_of(0), x->apart)));
    out->meet = 0;
    return out->apart == all;
}

FMB_INLINE fmb_pair_bits fmb_gaps_bits(const fmb_gaps *x, lane_mask known)
{
    fmb_pair_bits out = {0, lane_bits(lane_and(known, lane_less(x->meet, lane_of(0))))};
    out.apart = lane_bits(lane_and(known, lane_less(lane_of(0), x->apart)));
    return out;
}

/* The 3 x 3 cross product. */
FMB_INLINE void fmb_cross(const lane *a, const lane *b, lane *out)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = lane_fms(a[j], b[k], a[k] * b[j]);
    }
}

#endif
