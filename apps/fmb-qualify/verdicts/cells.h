/* cells.h: pairs of neighbouring and near cells of a mesh, as frames. */
#ifndef QUALIFY_CELLS_H
#define QUALIFY_CELLS_H

#include <fmb/mesh.h>

#include "fmb-qualify/verdicts/pool.h"

/* Triangles of positive area, in the order of a space-filling curve. */
typedef struct verdict_cells {
    size_t n;
    double edge;   /* mean length of the edges */
    double *point; /* [n][3][3] corners */
} verdict_cells;

/* [give, verdict_cells_close] From a mesh of triangles. Errors: MEMORY. */
fmb_status verdict_cells_open(const fmb_mesh *m, verdict_cells *out);
void verdict_cells_close(verdict_cells *c);

/* reshape of a verdict_source, self being verdict_cells: the drawn origins choose the two cells
 * that become the frames, in three dimensions. */
void verdict_cells_put(const void *self, int dim, const verdict_draft f[2]);

/* axes: [3][3]. The third becomes normal to the first two, of length `thick`. */
void verdict_make_thick(double *axes, double thick);

#endif
