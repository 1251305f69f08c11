/* fmplex.h: is a system feasible? Fourier-Motzkin elimination that tries bounds one by one instead
 * of pairing them all: singly exponential, and never more than m rows a level. */
#ifndef FMB_STUDY_FMPLEX_H
#define FMB_STUDY_FMPLEX_H

#include "base/arena.h"
#include "num/vec.h"
#include "num/weights.h"
#include "trace/run.h"

/* Like fmb_solve, connected part by connected part: with its evidence, limits, counters, watcher
 * and errors. Ignores the solver's options that choose an engine or rules; any order but
 * FMB_ORDER_GIVEN means FMplex's own. */
fmb_status study_fmplex_solve(fmb_solver *v, const fmb_system *s, fmb_result *res);

/* Decide row[i] (n coefficients, right side) REL rel[i], i < m, for real x[n]. If it is feasible, x
 * (unless NULL) is set to a solution; else multipliers over the m rows are appended to w (unless
 * NULL): they are >= 0 unless the row is an equality, and combine the rows to 0 <= negative or
 * 0 < 0. Errors: MEMORY, LIMIT. */
fmb_status study_fmplex_decide(fmb_run *run, fmb_arena *arena, int n, size_t m, const fmb_vec *row,
                               const fmb_rel *rel, const fmb_options *o, bool *feasible, mpq_t *x,
                               fmb_weights *w);

#endif
