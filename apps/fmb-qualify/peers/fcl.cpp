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

/* If FCL gives up by an exception, the verdict is unknown. */
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

/* ---- cuboids with right angles --------------------------------------------------------------- */

struct turned_box {
    fcl::OBB<double> bounds;
    fcl::Transform3<double> place;
    fcl::Box<double> shape;
};

struct boxes {
    std::vector<std::unique_ptr<turned_box>> p, q;
    fcl::CollisionRequest<double> how;
};

std::unique_ptr<turned_box> box_of(const fmb_frame &f)
{
    peer_box box;
    peer_box_of(&f, &box);
    std::unique_ptr<turned_box> out(new turned_box);
    fcl::Matrix3<double> axes;
    fcl::Vector3<double> centre(box.centre[0], box.centre[1], box.centre[2]),
        side(box.side[0], box.side[1], box.side[2]);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            axes(j, k) = box.axis[k][j];
    out->bounds = fcl::OBB<double>(axes, centre, side / 2);
    out->place = fcl::Transform3<double>::Identity();
    out->place.linear() = axes;
    out->place.translation() = centre;
    out->shape = fcl::Box<double>(side);
    return out;
}

fmb_status open_boxes(const peer_work *w, void **self)
{
    try {
        std::unique_ptr<boxes> s(new boxes);
        for (size_t i = 0; i < w->n; i++) {
            s->p.push_back(box_of(w->p[i]));
            s->q.push_back(box_of(w->q[i]));
        }
        s->how.enable_contact = false;
        s->how.num_max_contacts = 1;
        *self = s.release();
        return FMB_OK;
    } catch (const std::bad_alloc &) {
        return FMB_ERR_MEMORY;
    }
}

fmb_status ask_bounds(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    const boxes *s = static_cast<const boxes *>(self);
    for (size_t i = 0; i < n; i++)
        verdict[i] = s->p[first + i]->bounds.overlap(s->q[first + i]->bounds) ? FMB_FEASIBLE
                                                                              : FMB_INFEASIBLE;
    return FMB_OK;
}

fmb_status ask_boxes(void *self, size_t first, size_t n, fmb_verdict *verdict)
{
    const boxes *s = static_cast<const boxes *>(self);
    for (size_t i = 0; i < n; i++) {
        const turned_box &a = *s->p[first + i], &b = *s->q[first + i];
        fcl::CollisionResult<double> result;
        fcl::collide(&a.shape, a.place, &b.shape, b.place, s->how, result);
        verdict[i] = result.isCollision() ? FMB_FEASIBLE : FMB_INFEASIBLE;
    }
    return FMB_OK;
}

void close_boxes(void *self)
{
    delete static_cast<boxes *>(self);
}

} /* namespace */

extern "C" {
const peer_driver peer_fcl_ccd = {"FCL, libccd",  "collide() on Convex, no contacts, GST_LIBCCD",
                                  PEER_TAKES_ALL, open_ccd,
                                  ask_fcl,        close_fcl};
const peer_driver peer_fcl_own = {"FCL, own GJK", "collide() on Convex, no contacts, GST_INDEP",
                                  PEER_TAKES_ALL, open_own,
                                  ask_fcl,        close_fcl};
const peer_driver peer_fcl_obb = {"FCL OBB",  "overlap() of OBB", PEER_TAKES_BOXES,
                                  open_boxes, ask_bounds,         close_boxes};
const peer_driver peer_fcl_box = {"FCL box",        "collide() on Box, no contacts",
                                  PEER_TAKES_BOXES, open_boxes,
                                  ask_boxes,        close_boxes};
}
