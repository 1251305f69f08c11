/* ode.c: ODE's dCollide on convex geoms, for one contact, as it has no test without contacts. Its
 * dBoxBox takes only cuboids with right angles. ODE needs the origin of a geom inside it, so a geom
 * is placed at the frame's centre. */
#include <fcntl.h>
#include <math.h>
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "common/message.h"
#include "fmb-qualify/peers/peer.h"

enum { MOST_WORDS = 5 * PEER_MOST_FACES };

/* ODE keeps pointers to these. */
typedef struct ode_body {
    dGeomID geom;
    dReal plane[4 * PEER_MOST_FACES], point[3 * PEER_MOST_VERTICES];
    unsigned polygon[MOST_WORDS];
} ode_body;

typedef struct ode_state {
    size_t n;
    ode_body *p, *q; /* [n] */
} ode_state;

/* The plane of face i, with its normal outward and of length one. */
static void put_plane(const peer_hull *hull, const double *centre, int i, dReal *to)
{
    const double *a = hull->vertex[hull->face[i][0]], *b = hull->vertex[hull->face[i][1]],
                 *c = hull->vertex[hull->face[i][2]];
    double u[3], v[3], normal[3], length = 0, height = 0;
    for (int j = 0; j < 3; j++) {
        u[j] = b[j] - a[j];
        v[j] = c[j] - a[j];
    }
    for (int j = 0; j < 3; j++) {
        int s = (j + 1) % 3, t = (j + 2) % 3;
        normal[j] = u[s] * v[t] - u[t] * v[s];
        length += normal[j] * normal[j];
    }
    for (int j = 0; j < 3; j++) {
        to[j] = (dReal)(normal[j] / sqrt(length));
        height += to[j] * (a[j] - centre[j]);
    }
    to[3] = (dReal)height;
}

static void make_body(const fmb_frame *f, ode_body *out)
{
    peer_hull hull;
    double centre[3];
    unsigned *word = out->polygon;
    peer_hull_of(f, &hull);
    peer_centre(f, centre);
    for (int v = 0; v < hull.vertices; v++)
        for (int j = 0; j < 3; j++)
            out->point[3 * v + j] = (dReal)(hull.vertex[v][j] - centre[j]);
    for (int i = 0; i < hull.faces; i++) {
        put_plane(&hull, centre, i, out->plane + 4 * i);
        *word++ = (unsigned)hull.corners;
        for (int a = 0; a < hull.corners; a++)
            *word++ = (unsigned)hull.face[i][a];
    }
    out->geom = dCreateConvex(NULL, out->plane, (unsigned)hull.faces, out->point,
                              (unsigned)hull.vertices, out->polygon);
    dGeomSetPosition(out->geom, (dReal)centre[0], (dReal)centre[1], (dReal)centre[2]);
}

/* ODE prints warnings about thin geoms to standard output: redirect them for a while. Returns the
 * argument of hear(), -1 on failure. */
static int hush(void)
{
    fflush(stdout);
    int nowhere = open("/dev/null", O_WRONLY), kept = nowhere < 0 ? -1 : dup(STDOUT_FILENO);
    if (kept >= 0)
        dup2(nowhere, STDOUT_FILENO);
    if (nowhere >= 0)
        close(nowhere);
    return kept;
}

static void hear(int kept)
{
    fflush(stdout);
    if (kept < 0)
        return;
    dup2(kept, STDOUT_FILENO);
    close(kept);
}

/* One of ODE's own boxes. */
static void make_box(const fmb_frame *f, ode_body *out)
{
    peer_box box;
    dMatrix3 turn = {0};
    peer_box_of(f, &box);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            turn[4 * j + k] = (dReal)box.axis[k][j];
    out->geom = dCreateBox(NULL, (dReal)box.side[0], (dReal)box.side[1], (dReal)box.side[2]);
    dGeomSetPosition(out->geom, (dReal)box.centre[0], (dReal)box.centre[1], (dReal)box.centre[2]);
    dGeomSetRotation(out->geom, turn);
}

static fmb_status open_bodies(const peer_work *w, void (*make)(const fmb_frame *, ode_body *),
                              void **self)
{
    ode_state *s = app_need(malloc(sizeof *s));
    s->n = w->n;
    s->p = app_need(malloc(w->n * sizeof *s->p));
    s->q = app_need(malloc(w->n * sizeof *s->q));
    dInitODE2(0);
    dAllocateODEDataForThread((unsigned)dAllocateMaskAll);
    int kept = hush();
    for (size_t i = 0; i < w->n; i++) {
        make(&w->p[i], &s->p[i]);
        make(&w->q[i], &s->q[i]);
    }
    hear(kept);
    *self = s;
    return FMB_OK;
}

static fmb_status open_ode(const peer_work *w, void **self)
{
    return open_bodies(w, make_body, self);
}

static fmb_status open_ode_boxes(const peer_work *w, void **self)
{
    return open_bodies(w, make_box, self);
}

static fmb_status ask_ode(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    ode_state *s = self;
    dContactGeom contact;
    for (size_t i = 0; i < n; i++)
        verdict[i] =
            dCollide(s->p[first + i].geom, s->q[first + i].geom, 1, &contact, sizeof contact) > 0
                ? FMB_FEASIBLE
                : FMB_INFEASIBLE;
    return FMB_OK;
}

static void close_ode(void *self)
{
    ode_state *s = self;
    for (size_t i = 0; i < s->n; i++) {
        dGeomDestroy(s->p[i].geom);
        dGeomDestroy(s->q[i].geom);
    }
    dCloseODE();
    free(s->p);
    free(s->q);
    free(s);
}

const peer_driver peer_ode = {
    .name = "ODE",
    .how = "dCollide on convex geoms, one contact; by libccd where ODE was built with it",
    .open = open_ode,
    .ask = ask_ode,
    .close = close_ode};
const peer_driver peer_ode_box = {.name = "ODE box",
                                  .how = "dCollide on its boxes (dBoxBox), one contact",
                                  .takes = PEER_TAKES_BOXES,
                                  .open = open_ode_boxes,
                                  .ask = ask_ode,
                                  .close = close_ode};
