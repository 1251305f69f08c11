/* contact_near.c: see contact_near.h. */
#include "pair/contact/contact_near.h"

#include <float.h>
#include <math.h>

#include "pair/contact/epa.h"

typedef struct asked_bodies {
    fmb_bodies b;
    fmb_gjk g;
} asked_bodies;

/* Run GJK, starting from the difference of approximate centres; it stops once the distance is known
 * to exceed `enough` [world]. False: numbers underflow. */
static bool ask_nearest_point(const fmb_frame *p, const fmb_frame *q, double enough,
                              const fmb_hull_kernels *hulls, asked_bodies *x)
{
    double guess[3] = {0, 0, 0};
    const fmb_body_vertices *s = x->b.side;
    x->b.hulls = hulls;
    fmb_bodies_init(p, q, &x->b);
    x->g.b = &x->b;
    for (int j = 0; j < p->dim; j++)
        guess[j] = (s[0].x[j][0] + s[0].x[j][s[0].n / 2]) - (s[1].x[j][0] + s[1].x[j][s[1].n / 2]);
    if (x->b.known)
        fmb_gjk_nearest(&x->g, guess, ldexp(enough, -x->b.exponent));
    return x->b.known;
}

/* The distance is at least g.apart, and at most that between two points. */
static bool tell_distance(const asked_bodies *x, const fmb_frame *p, const fmb_frame *q,
                          fmb_pair_near *out)
{
    const fmb_bodies *b = &x->b;
    double point[2][3], time, length = 0, between = 0;
    fmb_gjk_points(&x->g, point, &time);
    for (int j = 0; j < b->dim; j++) {
        double way = point[0][j] - point[1][j] + time * b->drift[j];
        length += x->g.x[j] * x->g.x[j];
        between += way * way;
    }
    length = sqrt(length);
    out->has_row = false;
    out->length = ldexp(length, b->exponent);
    for (int j = 0; j < b->dim; j++) {
        out->normal[j] = -x->g.along[j];
        for (int k = 0; k < 2; k++) {
            const double *speed = k == 0 ? p->speed : q->speed;
            out->point[k][j] =
                fmb_bodies_place(b, p, j, point[k][j]) + (speed ? time * speed[j] : 0);
        }
    }
    return fmax(length, sqrt(between)) - x->g.apart <= 0x1p-41 * b->reach;
}

bool fmb_contact_distance(const fmb_frame *p, const fmb_frame *q, fmb_pair_near *out)
{
    asked_bodies x;
    return ask_nearest_point(p, q, INFINITY, NULL, &x) && x.g.apart > 0 &&
           tell_distance(&x, p, q, out);
}

/* An upper bound of the distance: the length of the point with the given weights, nonnegative and
 * over their sum. Coordinates of vertices are at most R with errors of 25 u R, those of the point
 * have less than 16 u R of rounding more: its length has an error of less than 128 u R. */
static double most_distance(fmb_gjk *g)
{
    double point[3] = {0, 0, 0}, sum = 0;
    if (g->weight[0] < 0)
        return fmb_gjk_is_inside(g) ? 0 : INFINITY;
    for (int i = 0; i < g->n; i++) {
        double weight = g->weight[i] > 0 ? g->weight[i] : 0;
        sum += weight;
        for (int j = 0; j < 3; j++)
            point[j] += weight * g->v[i].x[j];
    }
    double most = sqrt(fmb_dot3(point, point)) / sum * (1 + 8 * DBL_EPSILON);
    return most + 64 * DBL_EPSILON * g->b->reach;
}

bool fmb_contact_range(const fmb_frame *p, const fmb_frame *q, double enough, double range[2])
{
    asked_bodies x;
    if (!ask_nearest_point(p, q, enough, NULL, &x))
        return false;
    double most = ldexp(most_distance(&x.g), x.b.exponent);
    range[0] = x.g.apart > 0 ? nextafter(ldexp(x.g.apart, x.b.exponent), 0) : 0;
    range[1] = most >= 0 ? nextafter(most, INFINITY) : INFINITY;
    return true;
}

fmb_verdict fmb_contact_of_hulls(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                                 const fmb_hull_kernels *hulls, fmb_hulls_asked asked, bool *good,
                                 fmb_pair_near *out)
{
    asked_bodies x;
    const bool far = asked == FMB_HULLS_DISTANCE, deep = far || asked == FMB_HULLS_DEPTH;
    bool known = ask_nearest_point(p, q, far ? INFINITY : 0, hulls, &x);
    if (good)
        *good = false;
    if (known && x.g.apart > 0) {
        if (far)
            *good = tell_distance(&x, p, q, out);
        return FMB_INFEASIBLE;
    }
    bool inside = known && fmb_gjk_is_inside(&x.g);
    x.g.whole = known && !inside && fmb_bodies_are_whole(p, q, &x.b);
    if (!inside && !(x.g.whole && fmb_gjk_surrounds(&x.g)))
        return FMB_UNKNOWN;
    bool may_touch = x.g.whole && contact == FMB_CONTACT_OPEN;
    double depth, normal[3];
    bool told = (deep || may_touch) && fmb_epa_depth(&x.g, &depth, normal);
    if (may_touch && !(told && depth > 0))
        return FMB_UNKNOWN;
    if (!deep || !told)
        return FMB_FEASIBLE;
    *good = true;
    out->length = ldexp(depth, x.b.exponent);
    for (int j = 0; j < p->dim; j++)
        out->normal[j] = normal[j];
    return FMB_FEASIBLE;
}

/* The largest product of a vertex of the body with sign times n. */
static double reach_along(const fmb_body_vertices *s, int dim, const double *n, double sign)
{
    double most = -DBL_MAX;
    for (int v = 0; v < s->n; v++) {
        double at = 0;
        for (int j = 0; j < dim; j++)
            at += sign * n[j] * s->x[j][v];
        most = fmax(most, at);
    }
    return most;
}

/* Returns the middle of the gap; half of the gap must exceed the errors (gjk.h) of both bodies, and
 * the rounding of the product with the origin. */
double fmb_contact_offset_between(const fmb_frame *p, const double *normal, double low, double high,
                                  double reach, int exponent)
{
    double sum = 0, size = 0;
    double middle = ldexp(low / 2 + high / 2, exponent);
    double left = ldexp((high - low) / 2 - 32 * DBL_EPSILON * reach, exponent);
    for (int j = 0; j < p->dim; j++) {
        sum += normal[j] * p->origin[j];
        size += fabs(normal[j] * p->origin[j]);
    }
    double error = 8 * DBL_EPSILON * (size + fabs(middle)) + 32 * DBL_TRUE_MIN;
    return left * (1 - DBL_EPSILON) > error ? sum + middle : NAN;
}

double fmb_contact_offset(const fmb_frame *p, const fmb_frame *q, const double *normal)
{
    fmb_bodies b;
    b.hulls = NULL;
    fmb_bodies_init(p, q, &b);
    if (!b.known || b.moves)
        return NAN;
    double low = reach_along(&b.side[0], b.dim, normal, 1);
    double high = -reach_along(&b.side[1], b.dim, normal, -1);
    return fmb_contact_offset_between(p, normal, low, high, b.reach, b.exponent);
}
