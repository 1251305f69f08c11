/* plain_sat.c: see plain_sat.h. */
#include "plain_sat.h"

#include <math.h>

/* The values of a frame along a normal, relative to that of its origin: the width of their range,
 * and the sum of its ends. */
typedef struct span {
    double width, middle;
} span;

static span span_along(const fmb_frame *f, const double normal[2])
{
    const double *e = f->axes;
    const double u = e[0] * normal[0] + e[1] * normal[1], v = e[2] * normal[0] + e[3] * normal[1];
    if (f->shape == FMB_CUBOID)
        return (span){fabs(u) + fabs(v), u + v};
    double high = u > v ? u : v, low = u < v ? u : v;
    high = high > 0 ? high : 0;
    low = low < 0 ? low : 0;
    return (span){high - low, high + low};
}

/* Does an edge of direction (x, y) of one of the frames have a normal that separates them? */
static bool edge_separates(const fmb_frame *a, const fmb_frame *b, const double shift[2], double x,
                           double y)
{
    const double normal[2] = {-y, x};
    const span p = span_along(a, normal), q = span_along(b, normal);
    const double away = 2 * (shift[0] * normal[0] + shift[1] * normal[1]);
    return fabs(away + q.middle - p.middle) > p.width + q.width;
}

bool plain_sat_meet(const fmb_frame *a, const fmb_frame *b)
{
    const fmb_frame *const side[2] = {a, b};
    const double shift[2] = {b->origin[0] - a->origin[0], b->origin[1] - a->origin[1]};
    for (int i = 0; i < 2; i++) {
        const double *e = side[i]->axes;
        if (edge_separates(a, b, shift, e[0], e[1]) || edge_separates(a, b, shift, e[2], e[3]))
            return false;
        if (side[i]->shape == FMB_SIMPLEX && edge_separates(a, b, shift, e[2] - e[0], e[3] - e[1]))
            return false;
    }
    return true;
}
