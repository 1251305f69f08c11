/* canonical.h: the canonical form of a projection, the same whichever engine found it. */
#ifndef FMB_SOLVE_CANONICAL_H
#define FMB_SOLVE_CANONICAL_H

#include "solve/project/claimed_rows.h"

/* Bring the rows of a complete, irredundant, nonempty projection, and their claims, which are the
 * last of q, into canonical form: the same for all systems with the same solutions. place[] as in
 * fmb_claimed_rows_open. Errors: MEMORY, LIMIT; then the rows still describe the projection, in
 * some form. */
fmb_status fmb_query_canonical(fmb_query *q, const int *place, fmb_system *image);

/* Bring the strict rows that describe no facet into canonical form (faces_excluded.c).
 * Inequalities are reduced by the equations. Errors: MEMORY, LIMIT: as above. */
fmb_status fmb_canonical_faces(fmb_claimed_rows *c);

#endif
