/* canonical.h: the one form of a projection that all ways to it end in. */
#ifndef FMB_SOLVE_CANONICAL_H
#define FMB_SOLVE_CANONICAL_H

#include "solve/project/claimed_rows.h"

/* The rows of a complete and irredundant projection that is not empty, and their claims, which are
 * the last of q, get the canonical form: the same for all systems with the same solutions. place[]
 * as fmb_claimed_rows_open has it. Errors: MEMORY, LIMIT: then the rows are still those of the
 * projection, in some form. */
fmb_status fmb_query_canonical(fmb_query *q, const int *place, fmb_system *image);

/* The strict rows of it that describe no facet get their canonical form (faces_excluded.c).
 * Inequalities are reduced by the equations. Errors: MEMORY, LIMIT: as above. */
fmb_status fmb_canonical_faces(fmb_claimed_rows *c);

#endif
