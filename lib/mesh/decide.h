/* decide.h: how two cells meet: by signs of determinants, or as frames. */
#ifndef FMB_MESH_DECIDE_H
#define FMB_MESH_DECIDE_H

#include <fmb/pair.h>
#include <fmb/solve.h>

#include "mesh/mesh.h"

/* Vertices of a that are vertices of b. */
static inline int fmb_mesh_count_shared(const fmb_mesh_cell *a, const fmb_mesh_cell *b)
{
    int n = 0;
    for (int i = 0; i < a->corners; i++)
        for (int j = 0; j < b->corners; j++)
            n += a->id[i] == b->id[j];
    return n;
}

/* Two triangles, two tetrahedra, both with by_signs; shared: as above. */
fmb_mesh_how fmb_mesh_decide_triangles(const fmb_mesh_cell *a, const fmb_mesh_cell *b, int shared);
/* FMB_MESH_TOUCH may also be SHARE here, if shared > 0. */
fmb_mesh_how fmb_mesh_decide_tetrahedra(const fmb_mesh_cell *a, const fmb_mesh_cell *b, int shared);

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
/* Any two cells; if something moves, whether they meet (TOUCH). Errors: MEMORY. */
fmb_status fmb_mesh_decide_frames(fmb_mesh_frames *x, const fmb_mesh_cell *a,
                                  const fmb_mesh_cell *b, int shared, fmb_mesh_how *out);

#endif
