/* contact_face.c: see contact_face.h.
 *
 * All coordinates are the doubles of bodies.h. A vertex within 2^-40 reach (pair.h) of the farthest
 * one along the normal belongs to the face, as depth and normal may have such errors. Both faces
 * are projected to the plane perpendicular to the normal, where their corners have only rounding
 * errors, far below the tolerance of 2^-48.
 */
#include "pair/contact/contact_face.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "pair/contact/bodies.h"
#include "pair/contact/contact_polygon.h"

typedef struct contact_scene {
    fmb_bodies b;
    double fuzz;
    double across[2][3]; /* perpendicular to the normal; in the plane the second is 0 */
} contact_scene;

static void set_scene(const fmb_frame *p, const fmb_frame *q, const double *normal,
                      contact_scene *s)
{
    s->b.hulls = NULL;
    fmb_bodies_init(p, q, &s->b);
    s->fuzz = 0x1p-40 * s->b.reach;
    memset(s->across, 0, sizeof s->across);
    if (s->b.dim == 2) {
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

static double along(int dim, const double *n, const fmb_body_vertices *of, int v)
{
    double sum = 0;
    for (int j = 0; j < dim; j++)
        sum += n[j] * of->x[j][v];
    return sum;
}

/* The vertices of a body that are farthest along sign times the normal, as bits and as a polygon.
 * Returns their height along it. */
static double find_face(contact_scene *s, int side, const double *normal, int sign, uint8_t *bits,
                        fmb_polygon *out)
{
    const fmb_body_vertices *b = &s->b.side[side];
    double most = -DBL_MAX, height[FMB_BODY_MOST];
    for (int v = 0; v < b->n; v++) {
        height[v] = sign * along(s->b.dim, normal, b, v);
        most = fmax(most, height[v]);
    }
    *bits = 0;
    out->n = 0;
    for (int v = 0; v < b->n; v++) {
        if (height[v] < most - s->fuzz)
            continue;
        *bits = (uint8_t)(*bits | (b->n <= 8 ? 1 << v : 0));
        for (int i = 0; i < 2; i++)
            out->x[out->n][i] = along(s->b.dim, s->across[i], b, v);
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
        for (int j = 0; j < s.b.dim; j++)
            points[i * s.b.dim + j] =
                fmb_bodies_place(&s.b, p, j,
                                 height * normal[j] + common.x[i][0] * s.across[0][j] +
                                     common.x[i][1] * s.across[1][j]);
    return common.n;
}
