/* decide_corners.c: see cell.h. */
#include "pair/corners/cell.h"

#include "pair/corners/volume.h"

/* A triangle is flat if no projection of it has an area. */
bool fmb_cell_is_flat(const fmb_cell *c)
{
    static const double zero[3] = {0}, unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double *const *p = c->point;
    if (c->corners == 4)
        return fmb_sign_of_volume(p[0], p[1], p[2], p[3]) == 0;
    int k = 0;
    while (k < 3 &&
           fmb_sign_of_determinant((fmb_difference){p[1], p[0]}, (fmb_difference){p[2], p[0]},
                                   (fmb_difference){unit[k], zero}) == 0)
        k++;
    return k == 3;
}

bool fmb_cell_is_tame(const fmb_cell *c)
{
    bool tame = true;
    for (int k = 0; k < 3 * c->corners; k++)
        tame &= fmb_is_tame(c->point[k / 3][k % 3]);
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

/* The corners of b that are corners of a get the numbers that they have there. Corners of a that is
 * not flat are distinct. */
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
    if (!is_good_cell(p) || !is_good_cell(q) || p->naxes != q->naxes)
        return false;
    fmb_cell a = cell_of_frame(p), b = cell_of_frame(q);
    if (!fmb_cell_is_tame(&a) || !fmb_cell_is_tame(&b) || fmb_cell_is_flat(&a) ||
        fmb_cell_is_flat(&b))
        return false;
    number_shared_corners(&a, &b);
    unsigned common = fmb_cell_common(&a, &b);
    fmb_mesh_how how = a.corners == 3 ? fmb_decide_triangles(&a, &b, common)
                                      : fmb_decide_tetrahedra(&a, &b, fmb_cell_count(common));
    bool meet = contact == FMB_CONTACT_CLOSED ? how != FMB_MESH_APART
                                              : how == FMB_MESH_CROSS || how == FMB_MESH_COPLANAR;
    *out = meet ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return true;
}
