/* fcl.cpp: FCL's collide() on convex polytopes, without contacts, by libccd or by its own GJK. */
#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "fmb-qualify/peers/peer.h"

namespace
{

using convex = fcl::Convex<double>;

struct state {
    std::vector<std::unique_ptr<convex>> p, q;
    fcl::CollisionRequest<double> how;
};

std::unique_ptr<convex> convex_of(const fmb_frame &f)
{
    peer_hull hull;
    auto vertices = std::make_shared<std::vector<fcl::Vector3<double>>>();
    auto faces = std::make_shared<std::vector<int>>();
    peer_hull_of(&f, &hull);
    for (int v = 0; v < hull.vertices; v++)
        vertices->emplace_back(hull.vertex[v][0], hull.vertex[v][1], hull.vertex[v][2]);
    for (int i = 0; i < hull.faces; i++) {
        faces->push_back(hull.corners);
        faces->insert(faces->end(), hull.face[i], hull.face[i] + hull.corners);
    }
    return std::unique_ptr<convex>(new convex(vertices, hull.faces, faces));
}

fmb_status open_fcl(const peer_work *w, fcl::GJKSolverType solver, void **self)
{
    try {
        std::unique_ptr<state> s(new state);
        for (size_t i = 0; i < w->n; i++) {
            s->p.push_back(convex_of(w->p[i]));
            s->q.push_back(convex_of(w->q[i]));
        }
        s->how.enable_contact = false;
        s->how.num_max_contacts = 1;
        s->how.gjk_solver_type = solver;
        *self = s.release();
        return FMB_OK;
    } catch (const std::bad_alloc &) {
        return FMB_ERR_MEMORY;
    }
}

fmb_status open_ccd(const peer_work *w, void **self)
{
    return open_fcl(w, fcl::GJKSolverType::GST_LIBCCD, self);
}

fmb_status open_own(const peer_work *w, void **self)
{
    return open_fcl(w, fcl::GJKSolverType::GST_INDEP, self);
}

/* What FCL gives up on, by an exception, stays unknown. */
fmb_verdict collide(const state &s, size_t i)
{
    static const fcl::Transform3<double> here = fcl::Transform3<double>::Identity();
    fcl::CollisionResult<double> result;
    try {
        fcl::collide(s.p[i].get(), here, s.q[i].get(), here, s.how, result);
    } catch (const std::exception &) {
        return FMB_UNKNOWN;
    }
    return result.isCollision() ? FMB_FEASIBLE : FMB_INFEASIBLE;
}

fmb_status ask_fcl(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    const state *s = static_cast<const state *>(self);
    for (size_t i = 0; i < n; i++)
        verdict[i] = collide(*s, first + i);
    return FMB_OK;
}

void close_fcl(void *self)
{
    delete static_cast<state *>(self);
}

} /* namespace */

extern "C" {
const peer_driver peer_fcl_ccd = {"FCL, libccd", "collide() on Convex, no contacts, GST_LIBCCD",
                                  false,         open_ccd,
                                  ask_fcl,       close_fcl};
const peer_driver peer_fcl_own = {"FCL, own GJK", "collide() on Convex, no contacts, GST_INDEP",
                                  false,          open_own,
                                  ask_fcl,        close_fcl};
}
