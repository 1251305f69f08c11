/* clearance.h: the distance D up to which cells count as meeting. */
#ifndef FMB_MESH_CLEARANCE_H
#define FMB_MESH_CLEARANCE_H

#include <gmp.h>

#include "mesh/box.h"

typedef struct fmb_mesh_clearance {
    mpq_t square;        /* of D; 0: only cells that meet */
    double below, above; /* D lies between them */
    double gap;          /* boxes whose gap (box.h) is larger are more than D apart */
} fmb_mesh_clearance;

void fmb_mesh_clearance_init(fmb_mesh_clearance *m);
void fmb_mesh_clearance_clear(fmb_mesh_clearance *m);
/* Set D to "p" or "p/q", in decimal digits; NULL: D stays 0. False: that is no number, or is less
 * than 0. */
bool fmb_mesh_clearance_read(fmb_mesh_clearance *m, const char *text);
/* Set the square of D. */
void fmb_mesh_clearance_set(fmb_mesh_clearance *m, mpq_srcptr square);

/* Are the boxes so near that their cells must be tested? */
static inline bool fmb_mesh_boxes_are_near(const fmb_mesh_clearance *m, const fmb_mesh_box *p,
                                           const fmb_mesh_box *q)
{
    return m->gap > 0 ? fmb_mesh_boxes_gap(p, q) <= m->gap : fmb_mesh_boxes_meet(p, q);
}

#endif
