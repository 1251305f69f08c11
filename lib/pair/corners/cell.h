/* cell.h: triangles and tetrahedra in space given by corners, and how two of them meet, decided by
 * signs of determinants alone.
 */
#ifndef FMB_PAIR_CELL_H
#define FMB_PAIR_CELL_H

#include <string.h>

#include <fmb/frame.h>
#include <fmb/mesh.h>

#include "pair/corners/volume.h"

enum { FMB_CELL_MOST_CORNERS = 4 };

typedef struct fmb_cell {
    const double *point[FMB_CELL_MOST_CORNERS]; /* [3] each */
    uint32_t id[FMB_CELL_MOST_CORNERS];         /* equal for equal points, also of two cells; after
                                                   the last corner the id of the first */
    int corners;                                /* 3 or 4 */
} fmb_cell;

/* Are all coordinates tame (volume.h)? */
bool fmb_cell_is_tame(const fmb_cell *c);
/* Do the corners of a tame cell lie on a line (of a tetrahedron: in a plane)? */
bool fmb_cell_is_flat(const fmb_cell *c);

/* Is the point with this id a corner of c? */
static inline bool fmb_cell_has(const fmb_cell *c, uint32_t id)
{
    int k = 0;
    while (k < c->corners && c->id[k] != id)
        k++;
    return k < c->corners;
}

/* Bit k is 1 if corner k of a is one of b. */
static inline unsigned fmb_cell_common(const fmb_cell *a, const fmb_cell *b)
{
    typedef uint32_t four __attribute__((vector_size(16)));
    typedef uint64_t two __attribute__((vector_size(16)));
    four ids, equal = {0};
    memcpy(&ids, a->id, sizeof ids);
    for (int j = 0; j < FMB_CELL_MOST_CORNERS; j++)
        equal |= (four)(ids == b->id[j]);
    two bits = (two)(equal & (four){1, 2, 4, 8});
    uint64_t any = bits[0] | bits[1];
    return (unsigned)(any | any >> 32) & ((1u << a->corners) - 1);
}

/* The number of 1s among four bits. */
static inline int fmb_cell_count(unsigned bits)
{
    return (int)(UINT64_C(0x4332322132212110) >> 4 * bits & 15);
}

static inline fmb_triangle_plane fmb_plane_of_cell(const fmb_cell *c)
{
    return fmb_triangle_plane_of(c->point[0], c->point[1], c->point[2]);
}

/* Decide two triangles, tame and not flat; plane: of a; common: their fmb_cell_common. */
fmb_mesh_how fmb_decide_triangles(const fmb_cell *a, const fmb_triangle_plane *plane,
                                  const fmb_cell *b, unsigned common);
/* Two triangles in one plane, of which b may be flat. An axis that is not in the plane: */
int fmb_triangle_axis(const fmb_cell *a);
/* Seen along it: 1: an edge of a has all of b strictly outside; 0: outside or on it; -1: no edge
 * has. */
int fmb_separate_by_edges(int k, const fmb_cell *a, const fmb_cell *b);
/* With one common corner and relative interiors that do not meet, all common points lie in a line
 * through the corner that separates them: they are more than the corner iff this is true. */
bool fmb_have_edges_on_one_ray(int k, const fmb_cell *a, const fmb_cell *b);
/* Decide a tame triangle that is flat and one that is not, in a plane; CROSS, if the relative
 * interiors meet. False: the flat one is a point. */
bool fmb_decide_segment(const fmb_cell *flat, const fmb_cell *c, const fmb_triangle_plane *plane,
                        fmb_mesh_how *out);
/* Decide two tetrahedra with so many shared corners, tame and not flat. If shared > 0, the result
 * FMB_MESH_TOUCH may stand for SHARE. */
fmb_mesh_how fmb_decide_tetrahedra(const fmb_cell *a, const fmb_cell *b, int shared);

/* Do two frames meet? False, with *out unchanged: they are not both triangles or both tetrahedra
 * given by corners, or one moves, is not tame, or is flat. */
bool fmb_decide_corners(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                        fmb_verdict *out);

#endif
