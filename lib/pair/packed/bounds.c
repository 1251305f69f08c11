/* bounds.c: see bounds.h.
 *
 * A coordinate of a point of a frame is the sum of its origin's and at most nine of its axes' and
 * speed's, times factors in 0 ... 1; ends are such sums, each factor 0 or 1. Ten additions in
 * doubles err by less than 11 u S (u = 2^-53, S the sum of the absolute values, itself rounded) and
 * taking off 16 u S adds another u S. A sum less than 2^-1021 is exact, as it is a multiple of
 * 2^-1074. So where S is less than that nothing errs, whatever 16 u S is rounded to; and where it
 * is not, 16 u S is at least 2^-1070, and rounded by at most 2^-1075, less than the 4 u S that are
 * left. Sums that overflow make S infinite, and the box with it: a lower end is not +inf before
 * that, as all that is added to a finite number is at most 0; nor is an upper one -inf.
 */
#include "pair/packed/bounds.h"

#include <math.h>
#include <string.h>

static const double SLACK = 0x1p-49; /* 16 u */

/* ---- one frame ------------------------------------------------------------------------------- */

/* An end of the axes' contribution to a coordinate: of a simplex the extreme of 0 and each axis. */
typedef struct reach {
    double low, high, size;
} reach;

static reach reach_of_axes(const double *axes, int dim, int naxes, bool simplex, int j)
{
    reach r = {0, 0, 0};
    for (int k = 0; k < naxes; k++) {
        double x = axes[k * dim + j], low = x < 0 ? x : 0, high = x > 0 ? x : 0;
        r.low = !simplex ? r.low + low : low < r.low ? low : r.low;
        r.high = !simplex ? r.high + high : high > r.high ? high : r.high;
        r.size += fabs(x);
    }
    return r;
}

void fmb_bounds_of_frame(const fmb_frames *s, size_t i, fmb_bounds *out)
{
    const double *record = fmb_frames_record(s, i);
    int dim = s->dim, kind = s->kind[i];
    const double *axes = record + dim, *speed = axes + dim * dim;
    for (int j = 0; j < dim; j++) {
        reach r = reach_of_axes(axes, dim, fmb_kind_naxes(dim, kind),
                                fmb_kind_shape(kind) == FMB_SIMPLEX, j);
        double low = record[j] + (speed[j] < 0 ? speed[j] : 0) + r.low;
        double high = record[j] + (speed[j] > 0 ? speed[j] : 0) + r.high;
        double slack = SLACK * (fabs(record[j]) + fabs(speed[j]) + r.size);
        out->lower[j] = low - slack;
        out->upper[j] = high + slack;
    }
}

/* ---- eight frames ---------------------------------------------------------------------------- */

/* The lower ends of coordinate j of all eights; the upper ones follow. */
static double *ends_of_eights(const fmb_frames *s, int j)
{
    return s->bounds + 2 * s->eights * (size_t)j;
}

static size_t eight_of_place(const fmb_frames *s, size_t from)
{
    int kind = s->kind[s->order[from]];
    return s->first_eight[kind] + (from - s->first[kind]) / 8;
}

/* Of the eight frames g, in more than three dimensions: lower and upper ends by coordinate. */
static double *ends_of_frames(const fmb_frames *s, size_t g)
{
    return s->ends + 16 * (size_t)s->dim * g;
}

/* NULL: no frame, beyond all boxes. */
static void put_ends_of_frame(int dim, const fmb_bounds *box, double *ends)
{
    for (int j = 0; j < dim; j++) {
        ends[16 * j] = box ? box->lower[j] : INFINITY;
        ends[16 * j + 8] = box ? box->upper[j] : -INFINITY;
    }
}

/* Frames order[from ... to - 1]. */
static void put_bounds_of_eight(fmb_frames *s, size_t from, size_t to)
{
    size_t g = eight_of_place(s, from);
    for (size_t l = to - from; s->ends && l < 8; l++)
        put_ends_of_frame(s->dim, NULL, ends_of_frames(s, g) + l);
    for (size_t i = from; i < to; i++) {
        fmb_bounds box;
        fmb_bounds_of_frame(s, s->order[i], &box);
        if (s->ends)
            put_ends_of_frame(s->dim, &box, ends_of_frames(s, g) + (i - from));
        for (int j = 0; j < s->dim; j++) {
            double *low = ends_of_eights(s, j) + g, *high = low + s->eights;
            *low = i == from || box.lower[j] < *low ? box.lower[j] : *low;
            *high = i == from || box.upper[j] > *high ? box.upper[j] : *high;
        }
    }
}

void fmb_bounds_of_eights(fmb_frames *s)
{
    for (int kind = 0; s->bounds && kind < FMB_KIND_NONE; kind++)
        for (size_t from = s->first[kind], end = s->first[kind + 1]; from < end; from += 8)
            put_bounds_of_eight(s, from, from + 8 < end ? from + 8 : end);
}

uint64_t fmb_bounds_open_eights(const fmb_frames *s, size_t from, size_t eights,
                                const fmb_bounds *box)
{
    uint8_t apart[FMB_BOUNDS_MOST] = {0};
    size_t first = eight_of_place(s, from);
    uint64_t open = 0;
    for (int j = 0; j < s->dim; j++) {
        const double *low = ends_of_eights(s, j) + first, *high = low + s->eights;
        double lower = box->lower[j], upper = box->upper[j];
        for (size_t g = 0; g < eights; g++)
            apart[g] |= (low[g] > upper) | (high[g] < lower);
    }
    for (size_t g = 0; g < eights; g++)
        open |= (uint64_t)!apart[g] << g;
    return open;
}

/* Two at a time, as any processor can. */
bool fmb_bounds_are_beyond(const fmb_frames *s, size_t from, const fmb_bounds *box)
{
    typedef double two __attribute__((vector_size(16)));
    typedef int64_t masks __attribute__((vector_size(16)));
    const double *ends = ends_of_frames(s, eight_of_place(s, from));
    masks beyond[4] = {{0}};
    for (int j = 0; j < s->dim; j++, ends += 16) {
        const two lower = {box->lower[j], box->lower[j]}, upper = {box->upper[j], box->upper[j]};
        two low[4], high[4];
        memcpy(low, ends, sizeof low);
        memcpy(high, ends + 8, sizeof high);
        for (int l = 0; l < 4; l++) {
            beyond[l] |= (masks)(low[l] > upper);
            beyond[l] |= (masks)(high[l] < lower);
        }
    }
    const masks all = beyond[0] & beyond[1] & beyond[2] & beyond[3];
    return all[0] & all[1];
}
