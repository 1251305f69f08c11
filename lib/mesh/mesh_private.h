/* mesh_private.h: a mesh inside: vertices with their identities, cells with what is known of each,
 * and the tree of boxes over them.
 */
#ifndef FMB_MESH_MESH_PRIVATE_H
#define FMB_MESH_MESH_PRIVATE_H

#include <fmb/mesh.h>

#include "base/mem.h"
#include "mesh/box.h"
#include "pair/corners/cell.h"

/* Most cells of a leaf: what a pair of leaves costs is shared by more pairs of cells than with 4.
 */
enum { FMB_MESH_LEAF_CELLS = 16 };

/* A node of the tree: cells order[from .. to). A leaf has no children; else these are `left` and
 * `left` + 1. */
typedef struct fmb_mesh_node {
    fmb_mesh_box box;
    uint32_t from, to, left; /* left 0: a leaf */
} fmb_mesh_node;

/* What keeps a cell from being decided by signs. */
enum { FMB_MESH_FLAT = 1, FMB_MESH_WILD = 2 };

struct fmb_mesh {
    fmb_mem mem;
    int corners;
    size_t vertices, cells;
    double *point;    /* [vertices][3] */
    uint32_t *same;   /* [vertices] the first vertex at the same point */
    uint32_t *corner; /* [cells][corners] */
    uint32_t *face;   /* [cells] where in its file, or NULL */
    uint32_t *group;  /* [cells] where in `names` the name of its group begins, or NULL */
    char *names;      /* [names_size], a NUL behind each: the first, empty, is of no group */
    size_t names_size;
    uint8_t *faults;   /* [cells] FLAT: its corners lie in a line (of a tetrahedron: in a plane);
                           WILD: a coordinate is not tame (pair/corners/volume.h) */
    uint32_t *order;   /* [cells] of the tree */
    fmb_mesh_box *box; /* [cells] around cell order[i] */
    fmb_mesh_node *node;
    size_t nodes;
};

/* The cell as one of a mesh; `ids_of` lets points of two meshes be known as equal. */
static inline fmb_cell fmb_mesh_cell_of(const fmb_mesh *m, const uint32_t *ids_of, size_t c)
{
    fmb_cell out = {.corners = m->corners};
    const uint32_t *corner = m->corner + c * (size_t)m->corners;
    for (int k = 0; k < FMB_CELL_MOST_CORNERS; k++) {
        uint32_t vertex = corner[k < m->corners ? k : 0];
        out.point[k] = m->point + 3 * (size_t)vertex;
        out.id[k] = ids_of[vertex];
    }
    return out;
}

/* What a file says of its cells, as above: copied. */
typedef struct fmb_mesh_origin {
    const uint32_t *face, *group;
    const char *names;
    size_t names_size;
} fmb_mesh_origin;

/* fmb_mesh_new of cells from a file. */
fmb_status fmb_mesh_new_of_file(int corners, size_t vertices, const double *point, size_t cells,
                                const uint32_t *corner, const fmb_mesh_origin *origin,
                                const fmb_alloc *mem, fmb_mesh **out);

/* Build m->order, m->box and m->node. Errors: MEMORY. */
fmb_status fmb_mesh_grow_tree(fmb_mesh *m);

/* out[v] = the first vertex, of `other` and then of m, at the point of vertex v of m; those of m
 * count from other->vertices on. other may be NULL. Errors: MEMORY. */
fmb_status fmb_mesh_find_same(const fmb_mesh *m, const fmb_mesh *other, fmb_mem *mem,
                              uint32_t *out);

#endif
