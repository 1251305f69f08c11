/* flat.h: separating normals of a pair of frames with any number of axes each.
 *
 * A facet of the Minkowski difference B - A (swept along the drift if something moves) is parallel
 * to D - 1 independent directions: edges of A, edges of B, and the drift; the edges of one frame
 * lie in one of its faces. These directions give all normals (in space cross products of two
 * directions; in the plane one direction, turned by 90 degrees): if B - A has an interior, 0 is in
 * it iff 0 lies inside for all normals. Where there are too few directions for a normal, axes of
 * the world are added: normals made with these can only prove that frames are apart.
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
    uint8_t normal[FMB_FLAT_MOST_NORMALS][2]; /* its directions; in the plane only the first */
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
