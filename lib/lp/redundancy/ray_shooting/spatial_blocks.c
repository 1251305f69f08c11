/* spatial_blocks.c: sorts polar points so that neighbours are near each other; see polar_points.h.
 *
 * Points are split in two along the axis of their largest spread, and each half again (a k-d tree:
 * Bentley 1975), down to single blocks. Each block has an enclosing ball.
 */
#include <math.h>
#include <string.h>

#include "lp/redundancy/ray_shooting/polar_points.h"

/* Coordinate k of the point at a place. */
static double coordinate_at(const fmb_polar_points *p, size_t k, size_t at)
{
    return p->point_at[k * p->m + p->order[at]];
}

static size_t find_widest_axis(const fmb_polar_points *p, size_t from, size_t to)
{
    size_t widest = 0;
    double most = -1;
    for (size_t k = 0; k < p->d; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t at = from; at < to; at++) {
            double v = coordinate_at(p, k, at);
            low = v < low ? v : low;
            high = v > high ? v : high;
        }
        if (high - low > most) {
            most = high - low;
            widest = k;
        }
    }
    return widest;
}

static void swap_places(fmb_polar_points *p, size_t a, size_t b)
{
    size_t t = p->order[a];
    p->order[a] = p->order[b];
    p->order[b] = t;
}

/* Move smaller coordinates before the place `middle`, larger ones behind it (Hoare 1961, Find). */
static void select_by_coordinate(fmb_polar_points *p, size_t k, size_t from, size_t to,
                                 size_t middle)
{
    while (to - from > 1) {
        double pivot = coordinate_at(p, k, from + (to - from) / 2);
        size_t low = from, high = to - 1;
        while (low <= high) {
            while (coordinate_at(p, k, low) < pivot)
                low++;
            while (coordinate_at(p, k, high) > pivot)
                high--;
            if (low > high)
                break;
            swap_places(p, low++, high);
            if (high == 0)
                break;
            high--;
        }
        if (middle <= high)
            to = high + 1;
        else if (middle >= low)
            from = low;
        else
            return;
    }
}

static void split_points(fmb_polar_points *p, size_t from, size_t to)
{
    size_t blocks = (to - from + FMB_SPATIAL_BLOCK - 1) / FMB_SPATIAL_BLOCK;
    if (blocks < 2)
        return;
    size_t middle = from + blocks / 2 * FMB_SPATIAL_BLOCK;
    select_by_coordinate(p, find_widest_axis(p, from, to), from, to, middle);
    split_points(p, from, middle);
    split_points(p, middle, to);
}

/* A ball around the mean, larger than its rounding errors. */
static void enclose_block(fmb_polar_points *p, size_t b)
{
    size_t from = b * FMB_SPATIAL_BLOCK;
    size_t to = from + FMB_SPATIAL_BLOCK < p->m ? from + FMB_SPATIAL_BLOCK : p->m;
    double most = 0, square[FMB_SPATIAL_BLOCK] = {0};
    p->reach[b] = 0;
    for (size_t k = 0; k < p->d; k++) {
        double sum = 0;
        for (size_t at = from; at < to; at++)
            sum += p->point_at[k * p->m + at];
        double mean = p->middle[k * p->blocks + b] = sum / (double)(to - from);
        for (size_t at = from; at < to; at++) {
            double off = p->point_at[k * p->m + at] - mean;
            square[at - from] += off * off;
        }
    }
    for (size_t at = from; at < to; at++) {
        most = square[at - from] > most ? square[at - from] : most;
        p->reach[b] = p->size[at] > p->reach[b] ? p->size[at] : p->reach[b];
    }
    p->radius[b] = sqrt(most) + 0x1p-40 * p->reach[b];
}

/* Move values[i] of row i to the place of the row; there are no round points yet. */
static void put_in_order(const fmb_polar_points *p, double *values)
{
    double *scratch = p->round;
    memcpy(scratch, values, p->m * sizeof *values);
    for (size_t at = 0; at < p->m; at++)
        values[at] = scratch[p->order[at]];
}

void fmb_polar_points_arrange(fmb_polar_points *p)
{
    for (size_t at = 0; at < p->m; at++)
        p->order[at] = at;
    split_points(p, 0, p->m);
    for (size_t at = 0; at < p->m; at++)
        p->place[p->order[at]] = at;
    for (size_t k = 0; k < p->d; k++)
        put_in_order(p, &p->point_at[k * p->m]);
    if (p->d > 0)
        put_in_order(p, p->size);
    for (size_t b = 0; b < p->blocks; b++)
        enclose_block(p, b);
}
