/* single.c: see single.h. */
#include "pair/packed/single.h"

#include <float.h>
#include <math.h>

static float round_number(double x)
{
    const double size = fabs(x);
    return size == 0 || (size >= (double)FLT_MIN && size <= (double)FLT_MAX) ? (float)x : NAN;
}

static double largest_of_floats(const float *x, int n, double before)
{
    for (int j = 0; j < n; j++)
        before = fmax(before, fabs((double)x[j]));
    return before;
}

void fmb_single_add(fmb_frames *s, size_t i)
{
    const double *from = fmb_frames_record(s, i);
    float *to = s->single + s->stride * i;
    for (size_t j = 0; j < s->stride; j++) {
        to[j] = round_number(from[j]);
        s->rounded |= (double)to[j] != from[j];
    }
    s->far = largest_of_floats(to, s->dim, s->far);
    s->fast = largest_of_floats(to + s->dim * (s->dim + 1), s->dim, s->fast);
}
