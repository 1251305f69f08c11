/* mesh_private.h: the layout of a mesh: vertices with identities, cells with their faults, and the
 * tree of boxes over the cells.
 */
#ifndef FMB_MESH_MESH_PRIVATE_H
#define FMB_MESH_MESH_PRIVATE_H

#include <fmb/mesh.h>

#include "base/mem.h"
#include "mesh/box.h"
#include "pair/corners/cell.h"

/* The most cells of a leaf: with 4, the cost of a pair of leaves is shared by fewer pairs of cells.
 */
enum { FMB_MESH_LEAF_CELLS = 16 };

/* A node of the tree: cells order[from .. to). A leaf has no children; else these are `left` and
 * `left` + 1. */
typedef struct fmb_mesh_node {
    fmb_mesh_box box;
    uint32_t from, to, left; /* left 0: a leaf */
} fmb_mesh_node;

/* Faults that keep a cell from being decided by signs of determinants. */
enum { FMB_MESH_FLAT = 1, FMB_MESH_WILD = 2 };

struct fmb_mesh {
    fmb_mem mem;
    int corners;
    size_t vertices, cells;
    double *point;    /* [vertices][3] */
    uint32_t *same;   /* [vertices] the first vertex at the same point */
    uint32_t *corner; /* [cells][corners] */
    uint32_t *face;   /* [cells] number of the face in the file, or NULL */
    uint32_t *group;  /* [cells] offset in `names` of the name of its group, or NULL */
    char *names;      /* [names_size], each ends in NUL: the first, empty, means no group */
    size_t names_size;
    uint8_t *faults;   /* [cells] FLAT: its corners lie in a line (of a tetrahedron: in a plane);
                           WILD: a coordinate is not tame (pair/corners/volume.h) */
    uint32_t *order;   /* [cells] of the tree */
    fmb_mesh_box *box; /* [cells] around cell order[i] */
    fmb_mesh_node *node;
    size_t nodes;
};

/* Cell c of the mesh; ids_of[vertex] are equal for equal points, also of two meshes. */
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

/* The faces and groups of cells read from a file, as above; they are copied. */
typedef struct fmb_mesh_origin {
    const uint32_t *face, *group;
    const char *names;
    size_t names_size;
} fmb_mesh_origin;

/* fmb_mesh_new of cells from a file. */
fmb_status fmb_mesh_new_of_file(int corners, size_t vertices, const double *point, size_t cells,
                                const uint32_t *corner, const fmb_mesh_origin *origin,
                                const fmb_alloc *mem, fmb_mesh **out);

/* Fill m->order, m->box and m->node. */
void fmb_mesh_grow_tree(fmb_mesh *m);
/* The most nodes of a tree: no leaf has less than a quarter of FMB_MESH_LEAF_CELLS cells, unless it
 * is the root. */
static inline size_t fmb_mesh_most_nodes(size_t cells)
{
    return 2 * (cells / (FMB_MESH_LEAF_CELLS / 4)) + 1;
}

/* out[v] = the number of the first vertex at the point of vertex v of m, where vertices of `other`
 * come first and those of m count from other->vertices on. other may be NULL. Errors: MEMORY. */
fmb_status fmb_mesh_find_same(const fmb_mesh *m, const fmb_mesh *other, fmb_mem *mem,
                              uint32_t *out);

#endif
