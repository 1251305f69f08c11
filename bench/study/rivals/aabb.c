/* aabb.c: see aabb.h. */
#include "study/rivals/aabb.h"

#include <math.h>

void study_aabb_of(const fmb_frame *f, double *box)
{
    for (int j = 0; j < f->dim; j++) {
        double low = 0, high = 0;
        for (int k = 0; k < f->naxes; k++) {
            double edge = f->axes[k * f->dim + j];
            if (f->shape == FMB_CUBOID) {
                low += fmin(edge, 0);
                high += fmax(edge, 0);
            } else {
                low = fmin(edge, low);
                high = fmax(edge, high);
            }
        }
        double way = f->speed ? f->speed[j] : 0;
        box[2 * j] = f->origin[j] + low + fmin(way, 0);
        box[2 * j + 1] = f->origin[j] + high + fmax(way, 0);
    }
}

void study_aabb_meet(int dim, const double *a, const double *b, double *out)
{
    for (int j = 0; j < dim; j++) {
        out[2 * j] = fmax(a[2 * j], b[2 * j]);
        out[2 * j + 1] = fmin(a[2 * j + 1], b[2 * j + 1]);
    }
}

double study_aabb_volume(int dim, const double *box)
{
    double volume = 1;
    for (int j = 0; j < dim; j++)
        volume *= fmax(box[2 * j + 1] - box[2 * j], 0);
    return volume;
}

bool study_aabb_holds(int dim, const double *outer, const double *inner, double slack)
{
    for (int j = 0; j < dim; j++)
        if (!(outer[2 * j] - slack <= inner[2 * j] && outer[2 * j + 1] + slack >= inner[2 * j + 1]))
            return false;
    return true;
}

double study_aabb_scale(const fmb_frame *f)
{
    double most = 0;
    for (int j = 0; j < f->dim; j++) {
        double sum = fabs(f->origin[j]) + (f->speed ? fabs(f->speed[j]) : 0);
        for (int k = 0; k < f->naxes; k++)
            sum += fabs(f->axes[k * f->dim + j]);
        most = fmax(most, sum);
    }
    return most;
}
