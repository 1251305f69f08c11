/* recession.h: whether variables that go can go on for ever, away from all rows that name them. */
#ifndef FMB_SOLVE_RECESSION_H
#define FMB_SOLVE_RECESSION_H

#include <fmb/system.h>

#include "elim/round/elim.h"

/* drop[e->n]: variables that go. A glance is taken, and a search if that takes no more work
 * (trace/run.h) than patience. *recedes: all live rows that named one of
 * those have left e, and the others are the projection; else nothing has changed. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_recession_drop_rows(fmb_elim *e, const bool *drop, double patience, bool *recedes);

/* The same of a small system, on the stack: is it seen at once that no row of s is left?
 * place[dim]: -1 for variables that go. */
bool fmb_recession_drops_all_at_sight(const fmb_system *s, const int *place);

#endif
