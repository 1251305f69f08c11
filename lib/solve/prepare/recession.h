/* recession.h: directions of eliminated variables along which all rows that name these recede. */
#ifndef FMB_SOLVE_RECESSION_H
#define FMB_SOLVE_RECESSION_H

#include <fmb/system.h>

#include "elim/round/elim.h"

/* drop[e->n]: variables to eliminate. A quick try comes first, then a search of at most `patience`
 * work (trace/run.h). *recedes: all live rows that named one of them were removed from e, the
 * others are the projection; else e is unchanged. Errors: MEMORY, LIMIT. */
fmb_status fmb_recession_drop_rows(fmb_elim *e, const bool *drop, double patience, bool *recedes);

/* A quick test on the stack, for a small system: does the projection provably have no rows?
 * place[dim]: -1 for variables to eliminate. */
bool fmb_recession_drops_all_at_sight(const fmb_system *s, const int *place);

#endif
