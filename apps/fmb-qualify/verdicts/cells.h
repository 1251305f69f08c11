/* cells.h: pairs of neighbouring and near cells of a mesh, as frames. */
#ifndef QUALIFY_CELLS_H
#define QUALIFY_CELLS_H

#include <fmb/mesh.h>

#include "fmb-qualify/verdicts/pool.h"

/* Triangles with an area, each near those around it: along a curve through all of space. */
typedef struct verdict_cells {
    size_t n;
    double edge;   /* how long edges are, their mean */
    double *point; /* [n][3][3] corners */
} verdict_cells;

/* [give, verdict_cells_close] Of a mesh of triangles. Errors: MEMORY. */
fmb_status verdict_cells_open(const fmb_mesh *m, verdict_cells *out);
void verdict_cells_close(verdict_cells *c);

/* reshape of a verdict_source, self being verdict_cells: the origins that were drawn tell which two
 * cells become the frames, three-dimensional ones. */
void verdict_cells_put(const void *self, int dim, const verdict_draft f[2]);

/* axes: [3][3]. The third becomes normal to the first two, and that thick. */
void verdict_make_thick(double *axes, double thick);

#endif
