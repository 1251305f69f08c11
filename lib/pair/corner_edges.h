/* corner_edges.h: a frame by corners as one by edges, where its edges are doubles. */
#ifndef FMB_PAIR_CORNER_EDGES_H
#define FMB_PAIR_CORNER_EDGES_H

#include "frame/frame_private.h"

/* Frames by corners in more dimensions are asked exactly, and so are those with more axes. */
enum { FMB_EDGES_MOST_DIM = 3 };

/* Stands where it was made: frame may point into it. */
typedef struct fmb_corner_edges {
    fmb_frame frame;
    double axes[FMB_EDGES_MOST_DIM * FMB_EDGES_MOST_DIM];
} fmb_corner_edges;

/* f itself if it is by edges. False: some edge of f is no double, or there are too many. */
bool fmb_edges_of_frame(const fmb_frame *f, fmb_corner_edges *out);

#endif
