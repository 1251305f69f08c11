/* enumerate.c: see enumerate.h: the difference. Its corners are at most 512 without sign,
 * normals 2.1e6, their products 3.3e9; products of two of these are wide.
 */
#include "enumerate.h"

#include <stdlib.h>
#include <string.h>

int compare_fractions(fraction x, fraction y)
{
    wide d = x.p * y.q - y.p * x.q;
    return (d > 0) - (d < 0);
}

static long dot(const long *x, const long *y)
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

static void cross(const long *x, const long *y, long *out)
{
    for (int j = 0; j < 3; j++)
        out[j] = x[(j + 1) % 3] * y[(j + 2) % 3] - x[(j + 2) % 3] * y[(j + 1) % 3];
}

static void subtract(const long *x, const long *y, long *out)
{
    for (int j = 0; j < 3; j++)
        out[j] = x[j] - y[j];
}

static long sum_of_sizes(const long *x)
{
    return labs(x[0]) + labs(x[1]) + labs(x[2]);
}

/* ---- corners --------------------------------------------------------------------------------- */

static int count_corners(const solid *s)
{
    return s->cuboid ? 1 << s->naxes : s->naxes + 1;
}

static long corner_coordinate(const solid *s, int k, int j)
{
    long x = s->origin[j];
    for (int i = 0; i < s->naxes; i++)
        x += (s->cuboid ? k >> i & 1 : k == i + 1) ? s->edge[i][j] : 0;
    return x;
}

static void add_corner(minkowski *m, const long *x)
{
    for (int c = 0; c < m->corners; c++)
        if (memcmp(m->corner[c], x, sizeof m->corner[c]) == 0)
            return;
    memcpy(m->corner[m->corners++], x, sizeof *m->corner);
}

static void add_corners(const solid *a, const solid *b, minkowski *m)
{
    for (int c = 0; c < 2 * count_corners(a) * count_corners(b); c++) {
        long x[3] = {0};
        int time = c % 2, k = c / 2 % count_corners(a), l = c / 2 / count_corners(a);
        for (int j = 0; j < a->dim; j++)
            x[j] = corner_coordinate(a, k, j) - corner_coordinate(b, l, j) +
                   time * (a->speed[j] - b->speed[j]);
        add_corner(m, x);
    }
}

/* ---- planes ---------------------------------------------------------------------------------- */

static long greatest_common_divisor(long x, long y)
{
    return y == 0 ? labs(x) : greatest_common_divisor(y, x % y);
}

static void add_plane(minkowski *m, const long *n, long sign, const long *through)
{
    long g = greatest_common_divisor(n[0], greatest_common_divisor(n[1], n[2])) * sign;
    plane p = {.n = {n[0] / g, n[1] / g, n[2] / g}};
    p.c = dot(p.n, through);
    for (int i = 0; i < m->planes; i++)
        if (memcmp(m->plane[i].n, p.n, sizeof p.n) == 0)
            return;
    if (m->planes == ENUMERATE_MOST_PLANES)
        abort();
    m->plane[m->planes++] = p;
}

/* The plane at right angles to n through a corner, if no others lie on both sides. */
static void try_plane(minkowski *m, const long *n, const long *through)
{
    long at = dot(n, through);
    bool above = false, below = false;
    if (sum_of_sizes(n) == 0)
        return;
    for (int c = 0; c < m->corners && !(above && below); c++) {
        long d = dot(n, m->corner[c]) - at;
        above |= d > 0;
        below |= d < 0;
    }
    m->flat |= !above && !below;
    if (!above)
        add_plane(m, n, 1, through);
    if (!below)
        add_plane(m, n, -1, through);
}

static void add_planes(minkowski *m)
{
    static const long up[3] = {0, 0, 1};
    for (int a = 0; a < m->corners; a++)
        for (int b = 0; b < a; b++) {
            long n[3], x[3], y[3];
            subtract(m->corner[b], m->corner[a], x);
            if (m->dim == 2) {
                cross(x, up, n);
                try_plane(m, n, m->corner[a]);
            }
            for (int c = 0; m->dim == 3 && c < b; c++) {
                subtract(m->corner[c], m->corner[a], y);
                cross(x, y, n);
                try_plane(m, n, m->corner[a]);
            }
        }
}

void enumerate_difference(const solid *a, const solid *b, minkowski *out)
{
    out->dim = a->dim;
    out->corners = out->planes = 0;
    out->flat = false;
    add_corners(a, b, out);
    add_planes(out);
    out->flat |= out->planes == 0;
}

/* ---- distance -------------------------------------------------------------------------------- */

static void take_less(fraction *least, fraction x)
{
    if (least->q == 0 || compare_fractions(x, *least) < 0)
        *least = x;
}

/* From 0 to the line through a and b, where the nearest point lies between them. */
static void take_segment(const long *a, const long *b, fraction *least)
{
    long e[3];
    subtract(b, a, e);
    long along = -dot(a, e), length = dot(e, e);
    if (along > 0 && along < length)
        take_less(least, (fraction){(wide)dot(a, a) * length - (wide)along * along, length});
}

/* From 0 to the plane through a, b and c, where the nearest point h = n (n.a) / n.n lies between
 * them: det(b - a, h - a, n) and the two others are not negative. */
static void take_triangle(const long *a, const long *b, const long *c, fraction *least)
{
    const long *corner[3] = {a, b, c};
    long x[3], y[3], n[3], out[3];
    subtract(b, a, x);
    subtract(c, a, y);
    cross(x, y, n);
    long far = dot(n, a);
    wide square = (wide)n[0] * n[0] + (wide)n[1] * n[1] + (wide)n[2] * n[2];
    for (int i = 0; i < 3; i++) {
        wide inside = 0;
        subtract(corner[(i + 1) % 3], corner[i], x);
        cross(n, x, out); /* into the triangle; at right angles to n */
        for (int j = 0; j < 3; j++)
            inside -= (wide)out[j] * corner[i][j];
        if (inside < 0)
            return;
    }
    if (square > 0)
        take_less(least, (fraction){(wide)far * far, square});
}

static bool is_on_plane(const minkowski *m, int c, const plane *p)
{
    return !p || dot(p->n, m->corner[c]) == p->c;
}

/* The least of all corners, segments and triangles of corners on a plane, or of all. */
static void take_simplices(const minkowski *m, const plane *on, fraction *least)
{
    for (int a = 0; a < m->corners; a++) {
        if (!is_on_plane(m, a, on))
            continue;
        take_less(least, (fraction){dot(m->corner[a], m->corner[a]), 1});
        for (int b = 0; b < a; b++) {
            if (!is_on_plane(m, b, on))
                continue;
            take_segment(m->corner[a], m->corner[b], least);
            for (int c = 0; m->dim == 3 && c < b; c++)
                if (is_on_plane(m, c, on))
                    take_triangle(m->corner[a], m->corner[b], m->corner[c], least);
        }
    }
}

fraction enumerate_distance_square(const minkowski *m)
{
    fraction least = {0, 0};
    if (m->planes == 0)
        take_simplices(m, NULL, &least);
    for (int i = 0; i < m->planes; i++)
        if (m->plane[i].c < 0 || m->flat)
            take_simplices(m, &m->plane[i], &least);
    return least.q == 0 ? (fraction){0, 1} : least;
}

/* The cube of half side r meets the difference unless a plane with one of the normals of their
 * sum parts them: n.m > r |n|_1 for all m. Other normals do no harm. */
static void take_normal(const minkowski *m, const long *n, fraction *most)
{
    long low = dot(n, m->corner[0]), high = low, size = sum_of_sizes(n);
    for (int c = 1; c < m->corners; c++) {
        long x = dot(n, m->corner[c]);
        low = x < low ? x : low;
        high = x > high ? x : high;
    }
    fraction r = {low > 0 ? low : high < 0 ? -high : 0, size};
    if (size > 0 && compare_fractions(r, *most) > 0)
        *most = r;
}

fraction enumerate_distance_max(const minkowski *m)
{
    static const long unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    fraction most = {0, 1};
    for (int i = 0; i < m->planes; i++)
        take_normal(m, m->plane[i].n, &most);
    for (int j = 0; j < m->dim; j++)
        take_normal(m, unit[j], &most);
    for (int a = 0; a < m->corners; a++)
        for (int b = 0; b < a; b++)
            for (int j = m->dim == 3 ? 0 : 2; j < 3; j++) {
                long x[3], n[3];
                subtract(m->corner[a], m->corner[b], x);
                cross(x, unit[j], n);
                take_normal(m, n, &most);
            }
    return most;
}

/* ---- depth ----------------------------------------------------------------------------------- */

fraction enumerate_depth_square(const minkowski *m)
{
    fraction least = {0, 0};
    for (int i = 0; i < m->planes; i++) {
        const plane *p = &m->plane[i];
        wide square = (wide)p->n[0] * p->n[0] + (wide)p->n[1] * p->n[1] + (wide)p->n[2] * p->n[2];
        take_less(&least, (fraction){(wide)p->c * p->c, square});
    }
    return m->flat ? (fraction){0, 1} : least;
}

fraction enumerate_depth_max(const minkowski *m)
{
    fraction least = {0, 0};
    for (int i = 0; i < m->planes; i++)
        take_less(&least, (fraction){m->plane[i].c, sum_of_sizes(m->plane[i].n)});
    return m->flat ? (fraction){0, 1} : least;
}
