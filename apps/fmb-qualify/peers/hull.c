/* hull.c: see peer.h. */
#include "fmb-qualify/peers/peer.h"

#include <math.h>
#include <string.h>

static double determinant(const double *a)
{
    return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
           a[2] * (a[3] * a[7] - a[4] * a[6]);
}

/* Bit k of v: coordinate k is 1. */
static void put_vertex(const fmb_frame *f, unsigned v, double *to)
{
    for (int j = 0; j < 3; j++) {
        to[j] = f->origin[j];
        for (int k = 0; k < 3; k++)
            to[j] += v >> k & 1 ? f->axes[3 * k + j] : 0;
    }
}

/* Vertex v is the corner with bits v; faces c_i = 0, then c_i = 1. The right hand rule on axes i,
 * j, k makes the latter anticlockwise. */
static void cuboid_of(const fmb_frame *f, peer_hull *out)
{
    out->vertices = 8;
    out->faces = 6;
    out->corners = 4;
    for (unsigned v = 0; v < 8; v++)
        put_vertex(f, v, out->vertex[v]);
    for (int i = 0; i < 3; i++) {
        int at = 1 << i, j = 1 << (i + 1) % 3, k = 1 << (i + 2) % 3;
        const int low[4] = {0, k, j | k, j}, high[4] = {at, at | j, at | j | k, at | k};
        memcpy(out->face[i], low, sizeof low);
        memcpy(out->face[i + 3], high, sizeof high);
    }
}

/* Vertex 0 is the origin, vertex k + 1 the end of axis k. */
static void simplex_of(const fmb_frame *f, peer_hull *out)
{
    static const int FACE[4][4] = {{0, 3, 2}, {0, 1, 3}, {0, 2, 1}, {1, 2, 3}};
    out->vertices = 4;
    out->faces = 4;
    out->corners = 3;
    put_vertex(f, 0, out->vertex[0]);
    for (int k = 0; k < 3; k++)
        put_vertex(f, 1u << k, out->vertex[k + 1]);
    memcpy(out->face, FACE, sizeof FACE);
}

void peer_hull_of(const fmb_frame *f, peer_hull *out)
{
    if (f->shape == FMB_CUBOID)
        cuboid_of(f, out);
    else
        simplex_of(f, out);
    if (determinant(f->axes) >= 0)
        return;
    for (int i = 0; i < out->faces; i++)
        for (int a = 0, b = out->corners - 1; a < b; a++, b--) {
            int kept = out->face[i][a];
            out->face[i][a] = out->face[i][b];
            out->face[i][b] = kept;
        }
}

void peer_box_of(const fmb_frame *f, peer_box *out)
{
    double hand = determinant(f->axes) < 0 ? -1 : 1; /* a reflected frame needs one axis reversed */
    peer_centre(f, out->centre);
    for (int k = 0; k < 3; k++) {
        const double *a = f->axes + 3 * k;
        out->side[k] = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
        for (int j = 0; j < 3; j++)
            out->axis[k][j] = (k == 2 ? hand : 1) * a[j] / out->side[k];
    }
}

void peer_centre(const fmb_frame *f, double *out)
{
    double share = f->shape == FMB_CUBOID ? 0.5 : 0.25;
    for (int j = 0; j < 3; j++)
        out[j] = f->origin[j] + share * (f->axes[j] + f->axes[3 + j] + f->axes[6 + j]);
}
