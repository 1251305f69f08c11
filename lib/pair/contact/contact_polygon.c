/* contact_polygon.c: see contact_polygon.h.
 *
 * Sources: Andrew, Another efficient algorithm for convex hulls in two dimensions, Information
 * Processing Letters 9 (1979); Sutherland and Hodgman, Reentrant polygon clipping, Communications
 * of the ACM 17 (1974).
 */
#include "pair/contact/contact_polygon.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* The signed distance of x to the left of the line from a to b; if a = b, the distance from a. */
static double left_of(const double *a, const double *b, const double *x)
{
    double d[2] = {b[0] - a[0], b[1] - a[1]}, e[2] = {x[0] - a[0], x[1] - a[1]};
    double length = hypot(d[0], d[1]);
    return length > 0 ? (d[0] * e[1] - d[1] * e[0]) / length : hypot(e[0], e[1]);
}

static double distance(const double *a, const double *b)
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

static void polygon_copy(const fmb_polygon *from, fmb_polygon *to)
{
    memcpy(to->x, from->x, (size_t)from->n * sizeof from->x[0]);
    to->n = from->n;
}

static void polygon_add(fmb_polygon *p, const double *x)
{
    if (p->n < FMB_POLYGON_MOST)
        memcpy(p->x[p->n++], x, sizeof p->x[0]);
}

/* Seen from x, do a and b lie in opposite directions? */
static bool is_between(const double *a, const double *b, const double *x)
{
    return (a[0] - x[0]) * (b[0] - x[0]) + (a[1] - x[1]) * (b[1] - x[1]) < 0;
}

/* ---- hulls ----------------------------------------------------------------------------------- */

static void sort_corners(fmb_polygon *p)
{
    for (int i = 1; i < p->n; i++)
        for (int j = i; j > 0; j--) {
            double *a = p->x[j - 1], *b = p->x[j], t[2];
            if (a[0] < b[0] || (a[0] == b[0] && a[1] <= b[1]))
                break;
            memcpy(t, a, sizeof t);
            memcpy(a, b, sizeof t);
            memcpy(b, t, sizeof t);
        }
}

/* Remove corners that are within fuzz of the previous one, or of the side between their neighbours,
 * one after another. */
static void drop_corners(fmb_polygon *p, double fuzz)
{
    for (int i = 0; p->n > 1 && i < p->n;) {
        const double *before = p->x[(i + p->n - 1) % p->n], *after = p->x[(i + 1) % p->n];
        bool twice = distance(before, p->x[i]) <= fuzz;
        bool flat = p->n > 2 && is_between(before, after, p->x[i]) &&
                    fabs(left_of(before, after, p->x[i])) <= fuzz;
        if (!twice && !flat) {
            i++;
            continue;
        }
        memmove(p->x[i], p->x[i + 1], (size_t)(p->n - i - 1) * sizeof p->x[0]);
        p->n--;
        i = 0;
    }
}

void fmb_polygon_hull(fmb_polygon *p, double fuzz)
{
    fmb_polygon out;
    out.n = 0;
    sort_corners(p);
    for (int side = 0; side < 2; side++) { /* below from left to right, then above and back */
        int first = out.n;
        for (int i = 0; i < p->n; i++) {
            const double *x = p->x[side ? p->n - 1 - i : i];
            while (out.n > first + 1 && left_of(out.x[out.n - 2], out.x[out.n - 1], x) <= 0)
                out.n--;
            polygon_add(&out, x);
        }
        out.n -= p->n > 1; /* which begins the other side */
    }
    drop_corners(&out, fuzz);
    polygon_copy(&out, p);
}

/* ---- common points --------------------------------------------------------------------------- */

static void polygon_add_between(fmb_polygon *p, const double *a, const double *b, double t)
{
    const double x[2] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
    polygon_add(p, x);
}

static double clamp(double t)
{
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

/* Clip p to the left of the line from a to b; corners up to fuzz on its right are kept, too. If
 * nothing remains, p is unchanged. */
static void clip_by_side(fmb_polygon *p, const double *a, const double *b, double fuzz)
{
    fmb_polygon out;
    out.n = 0;
    for (int i = 0; i < p->n; i++) {
        const double *x = p->x[i], *y = p->x[(i + 1) % p->n];
        double s = left_of(a, b, x), t = left_of(a, b, y);
        if (s >= -fuzz)
            polygon_add(&out, x);
        if ((s < -fuzz) != (t < -fuzz))
            polygon_add_between(&out, x, y, clamp(s / (s - t)));
    }
    if (out.n > 0)
        polygon_copy(&out, p);
}

/* The intersection of two segments, a being the longer: b's ends along a, or the crossing. */
static void meet_segments(const fmb_polygon *a, const fmb_polygon *b, double fuzz, fmb_polygon *out)
{
    double length = distance(a->x[0], a->x[1]), t[2];
    double s[2] = {left_of(a->x[0], a->x[1], b->x[0]), left_of(a->x[0], a->x[1], b->x[1])};
    out->n = 0;
    if (fabs(s[1] - s[0]) > fuzz) {
        polygon_add_between(out, b->x[0], b->x[1], clamp(s[0] / (s[0] - s[1])));
        return;
    }
    for (int i = 0; i < 2; i++) {
        const double *x = b->x[i];
        t[i] = ((x[0] - a->x[0][0]) * (a->x[1][0] - a->x[0][0]) +
                (x[1] - a->x[0][1]) * (a->x[1][1] - a->x[0][1])) /
               (length * length);
        polygon_add_between(out, a->x[0], a->x[1], clamp(t[i]));
    }
}

void fmb_polygon_meet(const fmb_polygon *a, const fmb_polygon *b, double fuzz, fmb_polygon *out)
{
    if (a->n < b->n) {
        const fmb_polygon *t = a;
        a = b;
        b = t;
    }
    polygon_copy(b, out);
    if (a->n == 2 && b->n == 2) {
        bool longer = distance(a->x[0], a->x[1]) >= distance(b->x[0], b->x[1]);
        meet_segments(longer ? a : b, longer ? b : a, fuzz, out);
    }
    for (int i = 0; a->n > 2 && b->n > 1 && i < a->n; i++)
        clip_by_side(out, a->x[i], a->x[(i + 1) % a->n], fuzz);
    drop_corners(out, 4 * fuzz);
}

/* ---- fewer corners --------------------------------------------------------------------------- */

void fmb_polygon_reduce(fmb_polygon *p)
{
    int keep[4] = {0, 0, 0, 0}, n = 0;
    fmb_polygon out;
    out.n = 0;
    if (p->n <= 4)
        return;
    for (int i = 1; i < p->n; i++)
        if (distance(p->x[0], p->x[i]) > distance(p->x[0], p->x[keep[1]]))
            keep[1] = i;
    for (int i = 1; i < p->n; i++) {
        const double *a = p->x[0], *b = p->x[keep[1]];
        int side = i < keep[1] ? 2 : 3;
        if (i != keep[1] && (keep[side] == 0 ||
                             fabs(left_of(a, b, p->x[i])) > fabs(left_of(a, b, p->x[keep[side]]))))
            keep[side] = i;
    }
    for (int i = 0; i < p->n && n < 4; i++)
        if (i == keep[0] || i == keep[1] || i == keep[2] || i == keep[3]) {
            polygon_add(&out, p->x[i]);
            n++;
        }
    polygon_copy(&out, p);
}
