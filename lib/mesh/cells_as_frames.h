/* cells_as_frames.h: flat, wild (mesh_private.h) and moving cells, decided as pairs of frames. */
#ifndef FMB_MESH_CELLS_AS_FRAMES_H
#define FMB_MESH_CELLS_AS_FRAMES_H

#include <fmb/pair.h>
#include <fmb/proximity.h>
#include <fmb/solve.h>

#include "mesh/clearance.h"
#include "mesh/mesh_private.h"

/* The queries for pairs of frames; NULL until needed, as few meshes have such pairs. */
typedef struct fmb_mesh_frames {
    fmb_pair *closed, *open;
    fmb_solver *solver;
    fmb_alloc mem;
    const double *motion; /* of b, or NULL */
} fmb_mesh_frames;

/* fmb_mesh_frames_close what was opened. */
void fmb_mesh_frames_open(fmb_mesh_frames *x, const fmb_alloc *hook, const double *motion);
void fmb_mesh_frames_close(fmb_mesh_frames *x);
/* Decide any two cells; if something moves, only whether they meet (TOUCH). flat_b: b is flat.
 * Errors: MEMORY. */
fmb_status fmb_mesh_decide_frames(fmb_mesh_frames *x, const fmb_cell *a, const fmb_cell *b,
                                  bool flat_b, fmb_mesh_how *out);

/* range[0] <= the distance of two cells, b moving by motion or NULL, <= range[1]; as
 * fmb_contact_range. */
void fmb_mesh_cells_range(const fmb_cell *a, const fmb_cell *b, const double *motion, double enough,
                          double range[2]);
/* [give] The distance, exactly. Errors: MEMORY. */
fmb_status fmb_mesh_measure_cells(fmb_mesh_frames *x, const fmb_cell *a, const fmb_cell *b,
                                  fmb_proximity **out);
/* Are the cells within the clearance? *exactly: doubles could not decide. Errors: MEMORY. */
fmb_status fmb_mesh_cells_are_near(fmb_mesh_frames *x, const fmb_cell *a, const fmb_cell *b,
                                   const fmb_mesh_clearance *m, bool *exactly, bool *out);

#endif
