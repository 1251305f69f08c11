/* project_rays.h: the projection of a part by double description, some rays at a time. */
#ifndef FMB_SOLVE_PROJECT_RAYS_H
#define FMB_SOLVE_PROJECT_RAYS_H

#include "elim/round/elim.h"
#include "solve/query/solver.h"

/* A part on its way, in the query's arena. */
typedef struct fmb_ray_projection fmb_ray_projection;

/* Eliminate what is cheap of a part. *feasible false: its rows contradict each other. Errors:
 * MEMORY, LIMIT. Close *out, unless it is NULL, in any case. */
fmb_status fmb_ray_projection_open(fmb_query *q, int part, const int *place,
                                   fmb_ray_projection **out, bool *feasible);
void fmb_ray_projection_close(fmb_ray_projection *h);

/* Go on, until about that many more rays were made (0: any number). *done: the projection has been
 * appended to out, with claims, as fmb_query_project_part does; or *feasible is false. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_ray_projection_run(fmb_ray_projection *h, uint64_t rays, fmb_system *out,
                                  bool *feasible, bool *done);
/* The elimination that stopped where it was no longer cheap, and the part's variables that go, [n].
 * Whoever goes on with it comes back to where it was (elim/round/mark.h). */
fmb_elim *fmb_ray_projection_elimination(fmb_ray_projection *h, const bool **drop);
/* Few rows are still to come. */
bool fmb_ray_projection_is_nearly_done(const fmb_ray_projection *h);
/* Some numbers are longer than a word, or so long in all rows that those of combinations will be.
 */
bool fmb_ray_projection_is_long(const fmb_ray_projection *h);
/* [bits] About as long is a minor of all columns, if rows are like the mean of them. */
size_t fmb_ray_projection_minor_bits(const fmb_ray_projection *h);
/* Variables and rows that are left, coefficients, and rows with one of those. */
size_t fmb_ray_projection_columns(const fmb_ray_projection *h);
size_t fmb_ray_projection_rows(const fmb_ray_projection *h);
size_t fmb_ray_projection_entries(const fmb_ray_projection *h);
size_t fmb_ray_projection_bounds(const fmb_ray_projection *h);
/* All variables at 0 are a solution of what is left. */
bool fmb_ray_projection_has_origin(const fmb_ray_projection *h);
/* There is no use in going on: it must be eliminated. */
bool fmb_ray_projection_has_given_up(const fmb_ray_projection *h);
/* The least of dimensions and of rows beyond as many, of the cone: up to 10 or so it has few rays.
 */
size_t fmb_ray_projection_freedom(const fmb_ray_projection *h);

#endif
