/* cell.h: triangles and tetrahedra in space by their corners, and how two of them meet, by signs of
 * determinants alone.
 */
#ifndef FMB_PAIR_CELL_H
#define FMB_PAIR_CELL_H

#include <fmb/frame.h>
#include <fmb/mesh.h>

enum { FMB_CELL_MOST_CORNERS = 4 };

typedef struct fmb_cell {
    const double *point[FMB_CELL_MOST_CORNERS]; /* [3] each */
    uint32_t id[FMB_CELL_MOST_CORNERS];         /* of two cells equal where points are */
    int corners;                                /* 3 or 4 */
} fmb_cell;

/* All coordinates are tame (volume.h). */
bool fmb_cell_is_tame(const fmb_cell *c);
/* The corners of a tame cell lie in a line (of a tetrahedron: in a plane). */
bool fmb_cell_is_flat(const fmb_cell *c);

/* Corner id is one of c. */
static inline bool fmb_cell_has(const fmb_cell *c, uint32_t id)
{
    int k = 0;
    while (k < c->corners && c->id[k] != id)
        k++;
    return k < c->corners;
}

/* Corners of a that are corners of b. */
static inline int fmb_cells_count_shared(const fmb_cell *a, const fmb_cell *b)
{
    int n = 0;
    for (int i = 0; i < a->corners; i++)
        n += fmb_cell_has(b, a->id[i]);
    return n;
}

/* Two triangles, two tetrahedra, all tame and not flat; shared: as above. */
fmb_mesh_how fmb_decide_triangles(const fmb_cell *a, const fmb_cell *b, int shared);
/* FMB_MESH_TOUCH may also be SHARE here, if shared > 0. */
fmb_mesh_how fmb_decide_tetrahedra(const fmb_cell *a, const fmb_cell *b, int shared);

/* Do two frames meet? False, and *out is as it was: they are not both triangles or both tetrahedra
 * by their corners, still, tame and not flat. */
bool fmb_decide_corners(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                        fmb_verdict *out);

#endif
