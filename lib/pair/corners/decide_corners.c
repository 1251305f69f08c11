/* decide_corners.c: see cell.h. */
#include "pair/corners/cell.h"

#include "pair/corners/volume.h"

/* A triangle is flat if no projection of it has an area. */
bool fmb_cell_is_flat(const fmb_cell *c)
{
    const double *const *p = c->point;
    if (c->corners == 4)
        return fmb_sign_of_volume(p[0], p[1], p[2], p[3]) == 0;
    int k = 0;
    while (k < 3 && fmb_sign_of_turn(k, p[0], p[1], p[2]) == 0)
        k++;
    return k == 3;
}

bool fmb_cell_is_tame(const fmb_cell *c)
{
    bool tame = true;
    for (int k = 0; k < c->corners; k++)
        for (int j = 0; j < 3; j++)
            tame &= fmb_is_tame(c->point[k][j]);
    return tame;
}

/* ---- frames ---------------------------------------------------------------------------------- */

static fmb_cell cell_of_frame(const fmb_frame *f)
{
    fmb_cell c = {.corners = f->naxes + 1};
    for (int k = 0; k < FMB_CELL_MOST_CORNERS; k++) {
        int corner = k < c.corners ? k : 0;
        c.point[k] = corner == 0 ? f->origin : f->axes + 3 * (corner - 1);
        c.id[k] = (uint32_t)corner;
    }
    return c;
}

static bool are_equal_corners(const double *p, const double *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* Give corners of b that are corners of a the same ids. Corners of a, which is not flat, are
 * distinct. */
static void number_shared_corners(const fmb_cell *a, fmb_cell *b)
{
    for (int k = 0; k < FMB_CELL_MOST_CORNERS; k++) {
        int i = 0;
        while (i < a->corners && !are_equal_corners(a->point[i], b->point[k]))
            i++;
        b->id[k] = i < a->corners ? (uint32_t)i : FMB_CELL_MOST_CORNERS + b->id[k];
    }
}

static bool is_good_cell(const fmb_frame *f)
{
    return f->shape == FMB_SIMPLEX_BY_CORNERS && f->dim == 3 && !f->speed &&
           (f->naxes == 2 || f->naxes == 3);
}

bool fmb_decide_corners(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                        fmb_verdict *out)
{
    const fmb_frame *const frame[2] = {p, q};
    fmb_cell c[2];
    if (p->naxes != q->naxes)
        return false;
    for (int i = 0; i < 2; i++) {
        if (!is_good_cell(frame[i]))
            return false;
        c[i] = cell_of_frame(frame[i]);
        if (!fmb_cell_is_tame(&c[i]) || fmb_cell_is_flat(&c[i]))
            return false;
    }
    number_shared_corners(&c[0], &c[1]);
    unsigned common = fmb_cell_common(&c[0], &c[1]);
    fmb_triangle_plane plane = fmb_plane_of_cell(&c[0]);
    fmb_mesh_how how = c[0].corners == 3
                           ? fmb_decide_triangles(&c[0], &plane, &c[1], common)
                           : fmb_decide_tetrahedra(&c[0], &c[1], fmb_cell_count(common));
    bool meet = contact == FMB_CONTACT_CLOSED ? how != FMB_MESH_APART
                                              : how == FMB_MESH_CROSS || how == FMB_MESH_COPLANAR;
    *out = meet ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return true;
}
