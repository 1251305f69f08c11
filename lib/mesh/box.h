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

/* The greatest floats that are not above the four doubles. What is rounded up to 0 is -0, so the
 * float before it has the next integer as its bits, like that before any negative one. */
static inline fmb_float4 fmb_floats_below(const double x[4])
{
    typedef int32_t four __attribute__((vector_size(16)));
    typedef int64_t two __attribute__((vector_size(16)));
    typedef double doubles __attribute__((vector_size(16)));
    typedef double wide __attribute__((vector_size(32)));
    wide exact = {x[0], x[1], x[2], x[3]};
    fmb_float4 near = __builtin_convertvector(exact, fmb_float4);
    wide again = __builtin_convertvector(near, wide);
    two front = (two)((doubles){again[0], again[1]} > (doubles){x[0], x[1]});
    two back = (two)((doubles){again[2], again[3]} > (doubles){x[2], x[3]});
    four above = {(int32_t)front[0], (int32_t)front[1], (int32_t)back[0], (int32_t)back[1]};
    four bits = (four)near;
    return (fmb_float4)(bits - (above & (bits >> 31 | 1)));
}

/* The box from one corner to the other, whose fourth numbers are 0. */
static inline fmb_mesh_box fmb_mesh_box_around(const double lower[4], const double upper[4])
{
    const double minus[4] = {-upper[0], -upper[1], -upper[2], -upper[3]};
    return (fmb_mesh_box){fmb_floats_below(lower), -fmb_floats_below(minus)};
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
