/* support_inside.h: what the files of the support queries share; see support.h. */
#ifndef FMB_HULL_SUPPORT_INSIDE_H
#define FMB_HULL_SUPPORT_INSIDE_H

#include "hull/support.h"

/* What is noted of a facet of the hull. */
enum {
    FMB_FACET_OPEN = 0, /* it may be that the projection goes further */
    FMB_FACET_STANDS,
    FMB_FACET_MISSING /* the same, but the projection only comes near */
};

/* support_query.c: does the projection satisfy sign (h0 + h1 x1 + ...) >= 0, h[k + 1], which all
 * generators do? *stands: if so, and the row is written down, proof included (of an equality, with
 * sign -1 the reverse). Else the hull has grown. */
fmb_status fmb_support_query(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row,
                             bool *stands);
/* The point at which the oracle stands, if it is outside. */
fmb_status fmb_support_add_point(fmb_support *s);

/* support_row.c: a row is proved, or of no use. */
fmb_status fmb_support_write_row(fmb_support *s, const fmb_vec *h, fmb_support_row *row);
fmb_status fmb_support_keep(fmb_support *s, fmb_support_row *row);
void fmb_support_drop(fmb_support *s, fmb_support_row *row);

/* support_strict.c: all facets stand. Rows for the other faces that the projection lacks. */
fmb_status fmb_support_find_missing_faces(fmb_support *s);

#endif
