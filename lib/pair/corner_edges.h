/* corner_edges.h: a frame given by corners converted to edges, if its edges are doubles. */
#ifndef FMB_PAIR_CORNER_EDGES_H
#define FMB_PAIR_CORNER_EDGES_H

#include "frame/frame_private.h"

/* Frames by corners in more dimensions, or with more axes, are decided exactly instead. */
enum { FMB_EDGES_MOST_DIM = 3 };

/* Must not be copied: frame may point into it. */
typedef struct fmb_corner_edges {
    fmb_frame frame;
    double axes[FMB_EDGES_MOST_DIM * FMB_EDGES_MOST_DIM];
} fmb_corner_edges;

/* Convert f; a frame by edges is kept. False: some edge is no double, or there are too many. */
bool fmb_edges_of_frame(const fmb_frame *f, fmb_corner_edges *out);

#endif
