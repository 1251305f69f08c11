/* flat.h: what normals tell about a pair of frames with any number of axes each.
 *
 * A facet of B - A (with all places of B while it moves) is parallel to D - 1 independent
 * directions, of edges of A, edges of B, and of the drift; those of one frame belong to one of its
 * faces. So these are all the normals there are (in space cross products of two directions; in the
 * plane one direction, turned): if B - A has an interior then 0 is in it iff it lies inside on all
 * of them. Where the directions are too few for one normal, axes of the world stand in for them:
 * all they can tell is that frames are apart.
 *
 * Source: Gottschalk, Lin and Manocha 1996, for any faces.
 */
#ifndef FMB_FRAME_FLAT_H
#define FMB_FRAME_FLAT_H

#include <stdbool.h>
#include <stdint.h>

enum {
    FMB_FLAT_MOST_EDGES = 6,                  /* of a frame */
    FMB_FLAT_DRIFT = 2 * FMB_FLAT_MOST_EDGES, /* the number of that direction */
    FMB_FLAT_WORLD,                           /* and of the first axis of the world */
    FMB_FLAT_DIRECTIONS = FMB_FLAT_WORLD + 3,
    FMB_FLAT_MOST_NORMALS = 4 + 4 + 6 * 6 + 2 * 6
};

/* One side of a pair. Directions of edges: axis i, then the differences of a simplex. */
typedef struct fmb_flat_side {
    int naxes, edges;
    bool simplex;
} fmb_flat_side;

typedef struct fmb_flat_kind {
    int dim;
    bool moves;
    bool may_meet;    /* B - A may have an interior */
    bool needs_world; /* axes of the world are among the directions */
    fmb_flat_side side[2];
    int normals;
    uint8_t normal[FMB_FLAT_MOST_NORMALS][2]; /* its directions; in the plane the first one */
} fmb_flat_kind;

/* Edge `edge` >= naxes of a simplex goes from the end of axis [0] to that of axis [1]. */
static inline const uint8_t *fmb_flat_ends(int edge, int naxes)
{
    static const uint8_t ends[3][2] = {{0, 1}, {1, 2}, {2, 0}};
    return ends[edge - naxes];
}

/* dim is 2 or 3, and naxes at most dim. */
void fmb_flat_kind_of(int dim, bool moves, const int naxes[2], const bool simplex[2],
                      fmb_flat_kind *out);

#endif
