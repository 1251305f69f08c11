/* ends.c: see ends.h. */
#include "study/reference/ends.h"

#include <math.h>

#include "study/draw/pairs.h"
#include "study/reference/verdicts.h"

static const double slack = 1e-12; /* allowed, of the largest coordinate */

/* Coordinate j over f at t = 0: a cuboid adds every axis that goes that way, a simplex the one that
 * goes farthest. */
static double reach(const fmb_frame *f, int j, double side)
{
    double far = 0;
    for (int i = 0; i < f->naxes; i++) {
        double by = fmax(side * f->axes[i * f->dim + j], 0);
        far = f->shape == FMB_CUBOID ? far + by : fmax(far, by);
    }
    return f->origin[j] + side * far;
}

static double largest_of(const fmb_frame *f)
{
    double most = 0;
    for (int j = 0; j < f->dim; j++)
        for (int side = -1; side <= 1; side += 2) {
            double still = reach(f, j, side), later = still + (f->speed ? f->speed[j] : 0);
            most = fmax(most, fmax(fabs(still), fabs(later)));
        }
    return most;
}

double study_largest_coordinate(const fmb_frame *p, const fmb_frame *q)
{
    return fmax(largest_of(p), largest_of(q));
}

/* n intervals. An end of ours is a double: it lies beyond the exact one iff it lies beyond that one
 * rounded outward. */
static unsigned compare(const double *ours, const double *exact, int n, double size, bool tightest,
                        double *excess)
{
    unsigned faults = 0;
    for (int i = 0; i < 2 * n; i++) {
        double out = i % 2 ? ours[i] - exact[i] : exact[i] - ours[i];
        if (!(out >= 0))
            faults |= STUDY_FAULT_OUTSIDE;
        if (tightest ? out != 0 : !(out <= slack * size))
            faults |= tightest ? STUDY_FAULT_TIGHTEST : STUDY_FAULT_WIDE;
        if (out > 0)
            *excess = fmax(*excess, out / size);
    }
    return faults;
}

unsigned study_box_faults(const fmb_frame *p, const fmb_frame *q, const fmb_pair_answers *ours,
                          const fmb_pair_answers *exact, bool tightest, double *excess)
{
    double size = study_largest_coordinate(p, q);
    *excess = 0;
    return compare(ours->world, exact->world, p->dim, size, tightest, excess) |
           compare(ours->inside, exact->inside, q->naxes, 1, tightest, excess) |
           compare(ours->time, exact->time, 1, 1, tightest, excess);
}

fmb_status study_witness_system(const fmb_frame *p, const fmb_frame *q, const double *x,
                                fmb_system **out)
{
    double corner[STUDY_PAIR_MOST_DIM], axes[STUDY_PAIR_MOST_DIM * STUDY_PAIR_MOST_DIM] = {0};
    double near = slack * study_largest_coordinate(p, q) + 0x1p-1073;
    for (int j = 0; j < p->dim; j++) {
        corner[j] = x[j] - near;
        axes[j * p->dim + j] = 2 * near;
    }
    fmb_frame all[3] = {*p, *q, {FMB_CUBOID, p->dim, p->dim, corner, axes, NULL}};
    return fmb_system_from_frames(all, 3, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, out);
}
