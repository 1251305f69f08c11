/* guess.h: which rows will be tight? A floating-point simplex guesses; nothing that it says is
 * believed. */
#ifndef FMB_LP_GUESS_H
#define FMB_LP_GUESS_H

#include "lp/row.h"
#include "trace/run.h"

/* Mark rows that are tight at a vertex that GLPK thinks feasible, or where it gave up: tight[m]
 * comes in all false and stays so if there is no guess (small systems, no GLPK, numbers beyond
 * double). Errors: LIMIT. */
fmb_status fmb_lp_guess(fmb_run *run, int n, size_t m, const fmb_lp_row *rows, bool *tight);

#endif
