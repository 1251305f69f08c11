/* cells_as_frames.h: cells as pairs of frames: flat ones, wild ones, and those that move. */
#ifndef FMB_MESH_CELLS_AS_FRAMES_H
#define FMB_MESH_CELLS_AS_FRAMES_H

#include <fmb/pair.h>
#include <fmb/solve.h>

#include "mesh/mesh_private.h"

/* What asks pairs of cells as frames. */
typedef struct fmb_mesh_frames {
    fmb_pair *closed, *open;
    fmb_solver *solver;
    fmb_alloc mem;
    const double *motion; /* of b, or NULL */
} fmb_mesh_frames;

/* Errors: MEMORY. What was opened is to be closed. */
fmb_status fmb_mesh_frames_open(fmb_mesh_frames *x, const fmb_alloc *hook, const double *motion);
void fmb_mesh_frames_close(fmb_mesh_frames *x);
/* Any two cells; if something moves, whether they meet (TOUCH). flat_b: b is flat.
 * Errors: MEMORY. */
fmb_status fmb_mesh_decide_frames(fmb_mesh_frames *x, const fmb_cell *a, const fmb_cell *b,
                                  bool flat_b, int shared, fmb_mesh_how *out);

#endif
