/* corner_edges.c: see corner_edges.h. */
#include "pair/corner_edges.h"

/* d = b - a, rounded: is it exact? The rounding error is a double (Knuth, The Art of Computer
 * Programming 2, 4.2.2), unless d is infinite. */
static bool is_exact_difference(double b, double a, double d)
{
    double of_a = b - d, of_b = d + of_a;
    return (b - of_b) + (of_a - a) == 0;
}

bool fmb_edges_of_frame(const fmb_frame *f, fmb_corner_edges *out)
{
    out->frame = *f;
    if (!fmb_frame_is_by_corners(f->shape))
        return true;
    if (f->dim > FMB_EDGES_MOST_DIM || f->naxes > f->dim)
        return false;
    bool exact = true;
    for (int i = 0; i < f->naxes * f->dim; i++) {
        double corner = f->axes[i], origin = f->origin[i % f->dim];
        out->axes[i] = corner - origin;
        exact &= is_exact_difference(corner, origin, out->axes[i]);
    }
    out->frame.shape = f->shape == FMB_SIMPLEX_BY_CORNERS ? FMB_SIMPLEX : FMB_CUBOID;
    out->frame.axes = out->axes;
    return exact;
}
