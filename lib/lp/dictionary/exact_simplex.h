/* exact_simplex.h: programs on a dictionary: is it feasible, how far does a variable go. */
#ifndef FMB_LP_EXACT_SIMPLEX_H
#define FMB_LP_EXACT_SIMPLEX_H

#include "lp/dictionary/dictionary.h"

typedef enum fmb_lp_end {
    FMB_LP_OPTIMUM = 0,
    FMB_LP_UNBOUNDED,
    FMB_LP_VIOLATED /* fmb_lp_test: a point satisfies all other rows and not this one */
} fmb_lp_end;

/* Reach a feasible dictionary; *feasible false: none exists, fmb_lp_conflict says why. */
fmb_status fmb_lp_feasible(fmb_lp *lp, bool *feasible);

/* From a feasible dictionary: push x_j up (sign 1) or down (-1) as far as the rows allow. */
fmb_status fmb_lp_extreme(fmb_lp *lp, int j, int sign, fmb_lp_end *end);

/* ---- steps, for programs of other files ------------------------------------------------------ */

/* Count a program, and tell the watcher. */
void fmb_lp_begin(fmb_lp *lp);
/* fmb_lp_feasible, as a part of another program. */
fmb_status fmb_lp_make_feasible(fmb_lp *lp, bool *feasible);
/* The row that first reaches 0 when the variable of column j moves in the direction sign, SIZE_MAX
 * if none does; of equals the one of least variable. */
size_t fmb_lp_find_block(const fmb_lp *lp, size_t j, int sign);
/* A column whose variable, by entering, moves the basic variable of row r in the direction sign;
 * SIZE_MAX if none does. A free variable may move either way. */
size_t fmb_lp_find_entering(const fmb_lp *lp, size_t r, int sign);
/* fmb_lp_pivot, noting whether the step had any length. */
fmb_status fmb_lp_step(fmb_lp *lp, size_t r, size_t j);

#endif
