/* bodies.c: see bodies.h. */
#include "pair/contact/bodies.h"

#include <math.h>

#include "frame/frame_private.h"

/* Doubles times that power of two, in two factors as it may be as large as 2^1074. */
typedef struct power {
    double half, rest;
} power;

static double scaled(power s, double x)
{
    return x * s.half * s.rest;
}

static void measure_numbers(const double *x, int n, double *most)
{
    for (int i = 0; x && i < n; i++)
        *most = fabs(x[i]) > *most ? fabs(x[i]) : *most;
}

static bool is_cuboid(const fmb_frame *f)
{
    return f->shape == FMB_CUBOID || f->shape == FMB_CUBOID_BY_CORNERS;
}

/* The vertices of a cuboid, each from the one without its highest edge. */
static void place_cuboid(const fmb_frame *f, power s, const double *shift, fmb_bodies *b,
                         fmb_body_vertices *out)
{
    bool corners = f->shape == FMB_CUBOID_BY_CORNERS;
    out->n = 1 << f->naxes;
    out->edges = f->naxes;
    for (int j = 0; j < 3; j++)
        out->x[j][0] = shift[j];
    for (int i = 0; i < f->naxes; i++) {
        for (int j = 0; j < f->dim; j++) {
            double at = scaled(s, f->axes[i * f->dim + j]);
            out->edge[i][j] = corners ? at - scaled(s, f->origin[j]) : at;
        }
        out->edge[i][2] = f->dim == 2 ? 0 : out->edge[i][2];
        b->reach += fmb_size3(out->edge[i]);
        for (int v = 1 << i; v < 2 << i; v++)
            for (int j = 0; j < 3; j++)
                out->x[j][v] = out->x[j][v - (1 << i)] + out->edge[i][j];
    }
}

/* Corners are taken from p's origin at once. */
static void place_simplex(const fmb_frame *f, power s, const double *origin, const double *shift,
                          fmb_bodies *b, fmb_body_vertices *out)
{
    bool corners = f->shape == FMB_SIMPLEX_BY_CORNERS;
    double longest = 0, sum = 0, from[3] = {0, 0, 0}, own[3] = {0, 0, 0};
    out->n = f->naxes + 1;
    out->edges = 0;
    for (int j = 0; j < 3; j++)
        out->x[j][0] = shift[j];
    for (int j = 0; j < f->dim; j++) {
        from[j] = corners ? scaled(s, origin[j]) : -shift[j];
        own[j] = corners ? scaled(s, f->origin[j]) : 0;
    }
    for (int i = 0; i < f->naxes; i++) {
        double size = 0;
        out->x[2][i + 1] = 0;
        for (int j = 0; j < f->dim; j++) {
            double at = scaled(s, f->axes[i * f->dim + j]), edge = fabs(at - own[j]);
            out->x[j][i + 1] = at - from[j];
            size = edge > size ? edge : size;
        }
        longest = size > longest ? size : longest;
        sum += size;
    }
    b->reach += fmb_frame_is_hull(f) ? 2 * longest : sum;
}

void fmb_bodies_init(const fmb_frame *p, const fmb_frame *q, fmb_bodies *out)
{
    const fmb_frame *f[2] = {p, q};
    double most = 0, shift[2][3] = {{0}, {0}};
    out->dim = p->dim;
    out->moves = p->speed || q->speed;
    for (int k = 0; k < 2; k++) {
        measure_numbers(f[k]->origin, p->dim, &most);
        measure_numbers(f[k]->axes, f[k]->naxes * p->dim, &most);
        measure_numbers(f[k]->speed, p->dim, &most);
    }
    frexp(most, &out->exponent);
    power s = {ldexp(1, -(out->exponent / 2)), ldexp(1, -(out->exponent - out->exponent / 2))};
    for (int j = 0; j < 3; j++)
        out->drift[j] = 0;
    for (int j = 0; j < p->dim; j++) {
        shift[1][j] = scaled(s, q->origin[j]) - scaled(s, p->origin[j]);
        out->drift[j] =
            (p->speed ? scaled(s, p->speed[j]) : 0) - (q->speed ? scaled(s, q->speed[j]) : 0);
    }
    out->reach = fmb_size3(shift[1]) + fmb_size3(out->drift);
    for (int k = 0; k < 2; k++) {
        if (is_cuboid(f[k]))
            place_cuboid(f[k], s, shift[k], out, &out->side[k]);
        else
            place_simplex(f[k], s, p->origin, shift[k], out, &out->side[k]);
    }
    out->known = out->reach > 0x1p-300;
}

double fmb_bodies_place(const fmb_bodies *b, const fmb_frame *p, int j, double x)
{
    return p->origin[j] + ldexp(x, b->exponent);
}
