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

/* Numbers of a local frame, or their products: a bound; and if numbers of frames were rounded to
 * floats, how large they are as computed, and what they are off by for that. */
typedef struct fmb_bound {
    lane most;
    bool single; /* constant */
    lane size, off;
} fmb_bound;

/* A bound of numbers that are off by rounding alone. */
FMB_INLINE fmb_bound fmb_bound_rounded(lane most)
{
    return (fmb_bound){most, false, lane_of(0), lane_of(0)};
}

/* Numbers of a local frame, `found` as computed. */
FMB_INLINE fmb_bound fmb_bound_of(const local_frame *f, lane most, lane found)
{
    return (fmb_bound){most, true, found, f->input_error * most};
}

/* Of products of two. What is of second order is a 2^-13th, as sizes are 2^-8 of bounds at least.
 */
FMB_INLINE fmb_bound fmb_bound_times(fmb_bound a, fmb_bound b)
{
    fmb_bound out = fmb_bound_rounded(a.most * b.most);
    if (!a.single)
        return out;
    out.single = true;
    out.size = a.size * b.size;
    out.off = lane_fma(a.off, b.size, a.size * b.off);
    return out;
}

/* Of h H + S + n E + V. */
FMB_INLINE fmb_bound fmb_bound_of_sum(const local_frame *f, double h, double n)
{
    lane most = lane_fma(lane_of(h), f->most_shift, f->most_size);
    most = lane_fma(lane_of(n), f->most_e, most + f->most_drift);
    if (!f->single)
        return fmb_bound_rounded(most);
    lane found = lane_fma(lane_of(h), f->found_shift, f->found_size);
    return fmb_bound_of(f, most, lane_fma(lane_of(n), f->found_e, found + f->found_drift));
}

/* Of E. */
FMB_INLINE fmb_bound fmb_bound_of_edges(const local_frame *f)
{
    return f->single ? fmb_bound_of(f, f->most_e, f->found_e) : fmb_bound_rounded(f->most_e);
}

/* Of V, as a factor: the drift may be so small that products with it underflow, so 2^-100 E more.
 * Then errors are above 2^-700, and what underflows is off by 2^-1075. */
FMB_INLINE fmb_bound fmb_bound_of_speed(const local_frame *f)
{
    const lane most = lane_fma(lane_of(0x1p-100), f->most_e, f->most_drift);
    return f->single ? fmb_bound_of(f, most, f->found_drift) : fmb_bound_rounded(most);
}

/* count u times the bound, and times times what it is off by */
FMB_INLINE lane fmb_gaps_error(double count, double times, fmb_bound bound)
{
    lane error = lane_of(count * 0x1p-53) * bound.most;
    if (bound.single)
        error = lane_fma(lane_of(times), bound.off, error);
    return error;
}

/* Add a class whose largest gap has an error of at most that. */
FMB_INLINE void fmb_gaps_class(fmb_gaps *x, lane gap, double count, double times, fmb_bound bound)
{
    lane error = fmb_gaps_error(count, times, bound);
    x->apart = lane_max(x->apart, gap - error);
    x->meet = lane_max(x->meet, gap + error);
}

/* The first class there is. */
FMB_INLINE fmb_gaps fmb_gaps_first(lane gap, double count, double times, fmb_bound bound)
{
    lane error = fmb_gaps_error(count, times, bound);
    return (fmb_gaps){gap - error, gap + error};
}

/* The largest of gaps 0 ... i of a class, given that of those before. Numbers are constant where
 * loops are unrolled, and nothing is asked about the first. */
FMB_INLINE lane fmb_gaps_largest(int i, lane before, lane gap)
{
    return i == 0 ? gap : lane_max(before, gap);
}

/* Let lanes meet only if a number of that size exceeds its error: then its sign is certain. */
FMB_INLINE void fmb_gaps_certain(fmb_gaps *x, lane size, double count, double times,
                                 fmb_bound bound)
{
    x->meet = lane_max(x->meet, fmb_gaps_error(count, times, bound) - size);
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
