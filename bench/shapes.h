/* shapes.h: systems of two cuboids or simplices that may intersect, still or moving. */
#ifndef FMB_BENCH_SHAPES_H
#define FMB_BENCH_SHAPES_H

#include <fmb/system.h>

/* [give] Pair number i: kinds alternate between 2D and 8D, still and moving, and within a kind
 * cuboid and simplex on either side; no two pairs are alike. name[16] gets the kind: "3d-moving".
 * NULL if memory runs out. */
fmb_system *shape_pair(unsigned i, char name[16]);

/* The number of kinds. */
enum { SHAPE_KINDS = 14 };

#endif
