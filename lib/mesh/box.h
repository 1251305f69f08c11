/* box.h: axis-aligned bounding boxes in floats, rounded outward: they contain the cells. So boxes
 * that do not meet prove that the cells are apart; boxes that meet prove nothing.
 */
#ifndef FMB_MESH_BOX_H
#define FMB_MESH_BOX_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* A caller's memory need not be aligned for vectors. */
typedef float fmb_float4 __attribute__((vector_size(16), aligned(4)));

/* The fourth number is 0. */
typedef struct fmb_mesh_box {
    fmb_float4 lower, upper;
} fmb_mesh_box;

static inline fmb_mesh_box fmb_mesh_box_of_nothing(void)
{
    return (fmb_mesh_box){{INFINITY, INFINITY, INFINITY, 0}, {-INFINITY, -INFINITY, -INFINITY, 0}};
}

/* The greatest float that is not above x. Below: the least one that is not below x. */
static inline float fmb_float_below(double x)
{
    float near = (float)x;
    return (double)near > x ? nextafterf(near, -INFINITY) : near;
}

static inline float fmb_float_above(double x)
{
    return -fmb_float_below(-x);
}

/* The box from one corner to the other. */
static inline fmb_mesh_box fmb_mesh_box_around(const double lower[3], const double upper[3])
{
    fmb_mesh_box b = {{0}, {0}};
    for (int j = 0; j < 3; j++) {
        b.lower[j] = fmb_float_below(lower[j]);
        b.upper[j] = fmb_float_above(upper[j]);
    }
    return b;
}

/* The least box that contains both. */
static inline fmb_mesh_box fmb_mesh_box_join(fmb_mesh_box b, fmb_mesh_box c)
{
    typedef int32_t four __attribute__((vector_size(16), aligned(4)));
    four lower = c.lower<b.lower, upper = c.upper> b.upper;
    return (fmb_mesh_box){(fmb_float4)(((four)c.lower & lower) | ((four)b.lower & ~lower)),
                          (fmb_float4)(((four)c.upper & upper) | ((four)b.upper & ~upper))};
}

/* The box around the start and the end of a box that moves by motion[3]; NULL: it does not move. A
 * sum in doubles errs by less than the step from its float to the next one. */
static inline fmb_mesh_box fmb_mesh_box_sweep(fmb_mesh_box b, const double *motion)
{
    for (int j = 0; motion && j < 3; j++) {
        if (motion[j] < 0)
            b.lower[j] = nextafterf(fmb_float_below((double)b.lower[j] + motion[j]), -INFINITY);
        if (motion[j] > 0)
            b.upper[j] = nextafterf(fmb_float_above((double)b.upper[j] + motion[j]), INFINITY);
    }
    return b;
}

/* Without branches, as these would be unpredictable. */
static inline bool fmb_mesh_boxes_meet(const fmb_mesh_box *p, const fmb_mesh_box *q)
{
    typedef int64_t two __attribute__((vector_size(16), aligned(4)));
    two in_all = (two)((p->lower <= q->upper) & (q->lower <= p->upper));
    return (in_all[0] & in_all[1]) == -1;
}

/* The square of the distance of two boxes, with at most 6 rounding errors: differences of floats do
 * not underflow in doubles, nor do their squares. */
static inline double fmb_mesh_boxes_gap(const fmb_mesh_box *p, const fmb_mesh_box *q)
{
    double sum = 0;
    for (int j = 0; j < 3; j++) {
        double up = (double)q->lower[j] - (double)p->upper[j];
        double down = (double)p->lower[j] - (double)q->upper[j];
        double gap = up > down ? up : down;
        sum += gap > 0 ? gap * gap : 0;
    }
    return sum;
}

#endif
