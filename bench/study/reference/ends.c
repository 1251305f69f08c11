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

double study_neighbourhood(const fmb_frame *p, const fmb_frame *q)
{
    return slack * study_largest_coordinate(p, q) + 0x1p-1073;
}

/* In twice as many dimensions: v, and v again or nothing. */
static void put_twice(int dim, const double *v, bool again, double *out)
{
    for (int j = 0; j < dim; j++) {
        out[j] = v[j];
        out[dim + j] = again ? v[j] : 0;
    }
}

/* f with its axes and speed put so. */
static void put_frame_twice(const fmb_frame *f, bool again, double *number, fmb_frame *out)
{
    int dim = f->dim;
    double *axes = number + 4 * dim;
    *out =
        (fmb_frame){f->shape, 2 * dim, f->naxes, number, axes, f->speed ? number + 2 * dim : NULL};
    put_twice(dim, f->origin, again, number);
    if (f->speed)
        put_twice(dim, f->speed, again, number + 2 * dim);
    for (int k = 0; k < f->naxes; k++)
        put_twice(dim, f->axes + k * dim, again, axes + 2 * dim * k);
}

/* All (u, u) with u in one frame, and all (v, x) with v in the other, which is a cuboid, at any
 * time the same, x in the neighbourhood. */
bool study_witness_frames(const fmb_frame *p, const fmb_frame *q, const double *x,
                          study_witness_pair *out)
{
    int dim = p->dim;
    bool turn = q->shape != FMB_CUBOID;
    const fmb_frame *one = turn ? q : p, *other = turn ? p : q;
    double near = study_neighbourhood(p, q);
    if (other->shape != FMB_CUBOID || 2 * dim > STUDY_PAIR_MOST_DIM)
        return false;
    put_frame_twice(one, true, out->number[0], &out->frame[0]);
    put_frame_twice(other, false, out->number[1], &out->frame[1]);
    double *origin = out->number[1], *axis = origin + 4 * dim + 2 * dim * other->naxes;
    for (int j = 0; j < dim; j++, axis += 2 * dim) {
        origin[dim + j] = x[j] - near;
        for (int i = 0; i < 2 * dim; i++)
            axis[i] = i == dim + j ? 2 * near : 0;
    }
    out->frame[1].naxes += dim;
    return true;
}

fmb_status study_witness_system(const fmb_frame *p, const fmb_frame *q, const double *x,
                                fmb_system **out)
{
    double corner[STUDY_PAIR_MOST_DIM], axes[STUDY_PAIR_MOST_DIM * STUDY_PAIR_MOST_DIM] = {0};
    double near = study_neighbourhood(p, q);
    for (int j = 0; j < p->dim; j++) {
        corner[j] = x[j] - near;
        axes[j * p->dim + j] = 2 * near;
    }
    fmb_frame all[3] = {*p, *q, {FMB_CUBOID, p->dim, p->dim, corner, axes, NULL}};
    return fmb_system_from_frames(all, 3, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, out);
}
