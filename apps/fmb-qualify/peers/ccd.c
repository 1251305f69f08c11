/* ccd.c: libccd's GJK and MPR on support functions: the support point of a frame is the farthest of
 * its corners, found axis by axis for a cuboid. */
#include <ccd/ccd.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/peers/peer.h"

enum { ROUNDS = 100 }; /* as in libccd's own example; without a limit it may never end */

typedef struct ccd_state {
    peer_work work;
    ccd_t how;
} ccd_state;

static double dot(const double *x, const ccd_vec3_t *y)
{
    return x[0] * y->v[0] + x[1] * y->v[1] + x[2] * y->v[2];
}

static void add(ccd_vec3_t *to, const double *x)
{
    ccdVec3Set(to, to->v[0] + x[0], to->v[1] + x[1], to->v[2] + x[2]);
}

static void support(const void *object, const ccd_vec3_t *way, ccd_vec3_t *out)
{
    const fmb_frame *f = object;
    const double *best = NULL;
    double most = 0;
    ccdVec3Set(out, f->origin[0], f->origin[1], f->origin[2]);
    for (int k = 0; k < 3; k++) {
        const double *axis = f->axes + 3 * k;
        double far = dot(axis, way);
        if (f->shape == FMB_CUBOID && far > 0)
            add(out, axis);
        if (far > most) {
            most = far;
            best = axis;
        }
    }
    if (f->shape == FMB_SIMPLEX && best)
        add(out, best);
}

static void centre(const void *object, ccd_vec3_t *out)
{
    double x[3];
    peer_centre(object, x);
    ccdVec3Set(out, x[0], x[1], x[2]);
}

static fmb_status open_ccd(const peer_work *w, void **self)
{
    ccd_state *s = app_need(malloc(sizeof *s));
    s->work = *w;
    CCD_INIT(&s->how);
    s->how.support1 = s->how.support2 = support;
    s->how.center1 = s->how.center2 = centre;
    s->how.max_iterations = ROUNDS;
    *self = s;
    return FMB_OK;
}

static fmb_status ask_gjk(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    ccd_state *s = self;
    for (size_t i = 0; i < n; i++)
        verdict[i] = ccdGJKIntersect(&s->work.p[first + i], &s->work.q[first + i], &s->how)
                         ? FMB_FEASIBLE
                         : FMB_INFEASIBLE;
    return FMB_OK;
}

static fmb_status ask_mpr(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    ccd_state *s = self;
    for (size_t i = 0; i < n; i++)
        verdict[i] = ccdMPRIntersect(&s->work.p[first + i], &s->work.q[first + i], &s->how)
                         ? FMB_FEASIBLE
                         : FMB_INFEASIBLE;
    return FMB_OK;
}

const peer_driver peer_ccd_gjk = {.name = "libccd GJK",
                                  .how = "ccdGJKIntersect on support functions, 100 rounds at most",
                                  .open = open_ccd,
                                  .ask = ask_gjk,
                                  .close = free};
const peer_driver peer_ccd_mpr = {.name = "libccd MPR",
                                  .how = "ccdMPRIntersect on support functions, 100 rounds at most",
                                  .open = open_ccd,
                                  .ask = ask_mpr,
                                  .close = free};
