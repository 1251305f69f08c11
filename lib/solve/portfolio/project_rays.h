/* project_rays.h: the projection of a part by double description, some rays at a time. */
#ifndef FMB_SOLVE_PROJECT_RAYS_H
#define FMB_SOLVE_PROJECT_RAYS_H

#include "elim/round/elim.h"
#include "solve/query/solver.h"

/* A part on its way, in the query's arena. */
typedef struct fmb_lift fmb_lift;

/* Eliminate what is cheap of a part. *feasible false: its rows contradict each other. Errors:
 * MEMORY, LIMIT. Close *out, unless it is NULL, in any case. */
fmb_status fmb_lift_open(fmb_query *q, int part, const int *place, fmb_lift **out, bool *feasible);
void fmb_lift_close(fmb_lift *h);

/* Go on, until about that many more rays were made (0: any number). *done: the projection has been
 * appended to out, with claims, as fmb_query_project_part does; or *feasible is false. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_lift_run(fmb_lift *h, uint64_t rays, fmb_system *out, bool *feasible, bool *done);
/* The elimination that stopped where it was no longer cheap, and the part's variables that go, [n].
 * Whoever goes on with it comes back to where it was (elim/round/mark.h). */
fmb_elim *fmb_lift_elimination(fmb_lift *h, const bool **drop);
/* Few rows are still to come. */
bool fmb_lift_is_nearly_done(const fmb_lift *h);
/* Some numbers are longer than a word, or so long in all rows that those of combinations will be.
 */
bool fmb_lift_is_long(const fmb_lift *h);
/* [bits] About as long is a minor of all columns, if rows are like the mean of them. */
size_t fmb_lift_minor_bits(const fmb_lift *h);
/* Variables and rows that are left, coefficients, and rows with one of those. */
size_t fmb_lift_columns(const fmb_lift *h);
size_t fmb_lift_rows(const fmb_lift *h);
size_t fmb_lift_entries(const fmb_lift *h);
size_t fmb_lift_bounds(const fmb_lift *h);
/* All variables at 0 are a solution of what is left. */
bool fmb_lift_has_origin(const fmb_lift *h);
/* There is no use in going on: it must be eliminated. */
bool fmb_lift_has_given_up(const fmb_lift *h);
/* The least of dimensions and of rows beyond as many, of the cone: up to 10 or so it has few rays.
 */
size_t fmb_lift_freedom(const fmb_lift *h);

#endif
