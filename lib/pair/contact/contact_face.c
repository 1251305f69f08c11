/* contact_face.c: see contact_face.h.
 *
 * All in doubles, less the origin of p and over the power of two that is just above the largest
 * number, so that nothing overflows. Vertices that are within 2^-40 of the reach (pair.h has it) of
 * the farthest along the normal belong to the face: that is what depth and normal may be off by.
 * The faces are then looked at in the plane at right
 * angles to the normal, where their corners are off by what is rounded alone: 2^-48 is plenty.
 */
#include "pair/contact/contact_face.h"

#include <float.h>
#include <math.h>

#include "frame/frame_private.h"
#include "pair/contact/contact_polygon.h"

enum { MOST_VERTICES = 8 };

typedef struct contact_body {
    int n;
    double x[MOST_VERTICES][3], height[MOST_VERTICES];
} contact_body;

typedef struct contact_scene {
    int dim, exponent; /* of the largest number */
    double fuzz;
    contact_body body[2];
    double across[2][3]; /* at right angles to the normal; in the plane the second is 0 */
} contact_scene;

/* ---- vertices -------------------------------------------------------------------------------- */

static void measure_numbers(const fmb_frame *f, double *most)
{
    for (int i = 0; i < f->naxes * f->dim; i++)
        *most = fmax(*most, fabs(f->axes[i]));
    for (int j = 0; j < f->dim; j++)
        *most = fmax(*most, fabs(f->origin[j]));
}

/* Coordinate j of edge i of f. */
static double edge_of(const contact_scene *s, const fmb_frame *f, int i, int j)
{
    double at = ldexp(f->axes[i * f->dim + j], -s->exponent);
    return fmb_frame_is_by_corners(f->shape) ? at - ldexp(f->origin[j], -s->exponent) : at;
}

/* Vertex v has the edges of its bits, in a simplex edge v - 1. */
static void place_vertices(const contact_scene *s, const fmb_frame *f, const double *shift,
                           contact_body *out)
{
    bool cuboid = f->shape == FMB_CUBOID || f->shape == FMB_CUBOID_BY_CORNERS;
    out->n = cuboid ? 1 << f->naxes : f->naxes + 1;
    for (int v = 0; v < out->n; v++)
        for (int j = 0; j < s->dim; j++) {
            out->x[v][j] = shift[j];
            for (int i = 0; i < f->naxes; i++)
                if (cuboid ? v >> i & 1 : v == i + 1)
                    out->x[v][j] += edge_of(s, f, i, j);
        }
}

static void measure_reach(contact_scene *s, const fmb_frame *f)
{
    for (int i = 0; i < f->naxes; i++) {
        double most = 0;
        for (int j = 0; j < s->dim; j++)
            most = fmax(most, fabs(edge_of(s, f, i, j)));
        s->fuzz += most;
    }
}

static void set_scene(const fmb_frame *p, const fmb_frame *q, const double *normal,
                      contact_scene *s)
{
    double most = 0, shift[3] = {0}, none[3] = {0};
    *s = (contact_scene){.dim = p->dim};
    measure_numbers(p, &most);
    measure_numbers(q, &most);
    frexp(most, &s->exponent);
    for (int j = 0; j < s->dim; j++) {
        shift[j] = ldexp(q->origin[j], -s->exponent) - ldexp(p->origin[j], -s->exponent);
        s->fuzz = fmax(s->fuzz, fabs(shift[j]));
    }
    measure_reach(s, p);
    measure_reach(s, q);
    s->fuzz *= 0x1p-40;
    place_vertices(s, p, none, &s->body[0]);
    place_vertices(s, q, shift, &s->body[1]);
    if (s->dim == 2) {
        s->across[0][0] = -normal[1];
        s->across[0][1] = normal[0];
        return;
    }
    int a = fabs(normal[0]) < fabs(normal[1]) ? 0 : 1, b = (a + 1) % 3, c = (a + 2) % 3;
    double length = hypot(normal[b], normal[c]);
    s->across[0][b] = -normal[c] / length;
    s->across[0][c] = normal[b] / length;
    for (int j = 0; j < 3; j++)
        s->across[1][j] = normal[(j + 1) % 3] * s->across[0][(j + 2) % 3] -
                          normal[(j + 2) % 3] * s->across[0][(j + 1) % 3];
}

/* ---- faces ----------------------------------------------------------------------------------- */

static double along(int dim, const double *n, const double *x)
{
    double sum = 0;
    for (int j = 0; j < dim; j++)
        sum += n[j] * x[j];
    return sum;
}

/* The vertices of a body that are farthest along sign times the normal, as bits and as a polygon;
 * how far that is. */
static double find_face(contact_scene *s, int side, const double *normal, int sign, uint8_t *bits,
                        fmb_polygon *out)
{
    contact_body *b = &s->body[side];
    double most = -DBL_MAX;
    for (int v = 0; v < b->n; v++) {
        b->height[v] = sign * along(s->dim, normal, b->x[v]);
        most = fmax(most, b->height[v]);
    }
    *bits = 0;
    out->n = 0;
    for (int v = 0; v < b->n; v++) {
        if (b->height[v] < most - s->fuzz)
            continue;
        *bits = (uint8_t)(*bits | 1 << v);
        for (int i = 0; i < 2; i++)
            out->x[out->n][i] = along(s->dim, s->across[i], b->x[v]);
        out->n++;
    }
    fmb_polygon_hull(out, s->fuzz);
    return most;
}

int fmb_contact_face(const fmb_frame *p, const fmb_frame *q, const double *normal, uint8_t *faces,
                     double *points)
{
    contact_scene s;
    fmb_polygon a, b, common;
    set_scene(p, q, normal, &s);
    double height = find_face(&s, 0, normal, 1, &faces[0], &a);
    find_face(&s, 1, normal, -1, &faces[1], &b);
    fmb_polygon_meet(&a, &b, s.fuzz * 0x1p-8, &common);
    fmb_polygon_reduce(&common);
    for (int i = 0; i < common.n; i++)
        for (int j = 0; j < s.dim; j++) {
            double at = height * normal[j] + common.x[i][0] * s.across[0][j] +
                        common.x[i][1] * s.across[1][j];
            points[i * s.dim + j] = p->origin[j] + ldexp(at, s.exponent);
        }
    return common.n;
}
