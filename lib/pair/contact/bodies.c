/* bodies.c: see bodies.h. */
#include "pair/contact/bodies.h"

#include <math.h>

#include "frame/frame_private.h"

/* A power of two as two factors, as it may be as large as 2^1074. */
typedef struct power {
    double factor[2];
} power;

static double scaled(power s, double x)
{
    return x * s.factor[0] * s.factor[1];
}

static double measure_numbers(const double *x, int n, double most)
{
    for (int i = 0; x && i < n; i++)
        most = fabs(x[i]) > most ? fabs(x[i]) : most;
    return most;
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

/* Over the vectors from the first vertex to each: the sum of the sizes, or for a hull twice the
 * largest. Four at once, as vertices are padded. */
static double reach_of_simplex(const fmb_body_vertices *s, bool hull)
{
    double longest[4] = {0, 0, 0, 0}, sum = 0;
    for (int v = 0; v < s->n; v += 4) {
        double size[4] = {0, 0, 0, 0};
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 4; k++) {
                double edge = fabs(s->x[j][v + k] - s->x[j][0]);
                size[k] = edge > size[k] ? edge : size[k];
            }
        for (int k = 0; k < 4; k++)
            longest[k] = size[k] > longest[k] ? size[k] : longest[k];
        sum += size[0] + size[1] + (size[2] + size[3]);
    }
    double two = longest[1] > longest[0] ? longest[1] : longest[0];
    double other = longest[3] > longest[2] ? longest[3] : longest[2];
    return hull ? 2 * (other > two ? other : two) : sum;
}

/* Corners are converted directly to coordinates relative to p's origin. */
static void place_simplex(const fmb_frame *f, power s, const double *origin, const double *shift,
                          fmb_bodies *b, fmb_body_vertices *out)
{
    bool corners = f->shape == FMB_SIMPLEX_BY_CORNERS;
    int n = out->n = f->naxes + 1;
    double move[3];
    out->edges = 0;
    for (int j = 0; j < 3; j++)
        move[j] = j >= f->dim ? 0 : corners ? scaled(s, origin[j]) : -shift[j];
    if (n > 4 && f->dim == 3 && b->hulls) {
        b->reach += 2 * b->hulls->place(f->axes, f->naxes, s.factor, move, shift, out->x[0]);
        return;
    }
    for (int j = 0; j < 3; j++) {
        const double *at = f->axes + (j < f->dim ? j : 0);
        for (int v = 1; v < n; v++, at += f->dim)
            out->x[j][v] = scaled(s, *at) - move[j];
        for (int v = 1; j >= f->dim && v < n; v++)
            out->x[j][v] = 0;
        for (int v = n; v % (n > 4 ? 8 : 4) != 0; v++)
            out->x[j][v] = shift[j];
        out->x[j][0] = shift[j];
    }
    b->reach += reach_of_simplex(out, fmb_frame_is_hull(f));
}

static void place_bodies(const fmb_frame *const f[2], power s, fmb_bodies *out)
{
    const fmb_frame *p = f[0], *q = f[1];
    double shift[2][3] = {{0}, {0}};
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
}

/* Most pairs have sizes at which nothing overflows or underflows without scaling: so vertices are
 * computed unscaled first, before the sizes of numbers are checked. */
void fmb_bodies_init(const fmb_frame *p, const fmb_frame *q, fmb_bodies *out)
{
    const fmb_frame *const f[2] = {p, q};
    double most = 0;
    out->dim = p->dim;
    out->moves = p->speed || q->speed;
    out->exponent = 0;
    out->known = true;
    place_bodies(f, (power){{1, 1}}, out);
    if (out->reach > 0x1p-100 && out->reach < 0x1p100)
        return;
    for (int k = 0; k < 2; k++) {
        most = measure_numbers(f[k]->origin, p->dim, most);
        most = measure_numbers(f[k]->axes, f[k]->naxes * p->dim, most);
        most = measure_numbers(f[k]->speed, p->dim, most);
    }
    frexp(most, &out->exponent);
    place_bodies(
        f,
        (power){{ldexp(1, -(out->exponent / 2)), ldexp(1, -(out->exponent - out->exponent / 2))}},
        out);
    out->known = out->reach > 0x1p-300;
}

static bool are_multiples(const double *x, int n, double finer)
{
    bool good = true;
    for (int i = 0; x && i < n && good; i++)
        good = x[i] * finer == rint(x[i] * finer);
    return good;
}

bool fmb_bodies_are_whole(const fmb_frame *p, const fmb_frame *q, const fmb_bodies *b)
{
    const fmb_frame *const f[2] = {p, q};
    if (b->exponent != 0)
        return false;
    const double finer = ldexp(1, 15 - ilogb(b->reach));
    bool good = true;
    for (int k = 0; k < 2 && good; k++)
        good = are_multiples(f[k]->origin, p->dim, finer) &&
               are_multiples(f[k]->axes, f[k]->naxes * p->dim, finer) &&
               are_multiples(f[k]->speed, p->dim, finer);
    return good;
}

double fmb_bodies_place(const fmb_bodies *b, const fmb_frame *p, int j, double x)
{
    return p->origin[j] + ldexp(x, b->exponent);
}
