/* basis.h: a basis of the program of a pair, solved in whole numbers, and steps from one to the
 * next: what propose.c stands on. Nothing here has to be right (propose.h).
 */
#ifndef FMB_STUDY_BASIS_H
#define FMB_STUDY_BASIS_H

#include "pair/general/workspace.h"
#include "study/reference/equations.h"
#include "study/reference/propose.h"

/* Unknowns that are as near to an end may be at it: guesses. */
#define TINY 0x1p-30

enum {
    ROWS = STUDY_EQUATIONS_MOST,
    COLUMNS = STUDY_MEETING_MOST_COLUMNS + 2,
    BITS = 62 /* of unknowns that are set, below the point */
};

struct study_proposer {
    fmb_mem mem;
    fmb_general *g;
    study_equations e;
    int factored[ROWS]; /* the pivots whose columns e has factored; the first may be -1: none */
    /* where the last end of the pair was found */
    bool has_end;
    int end_pivot[ROWS];
    double end_vertex[COLUMNS];
    int group_bits[3], column_bits[COLUMNS], row_bits[STUDY_PAIR_MOST_DIM]; /* scales (propose.c) */
    mpz_t z[COLUMNS], y[ROWS], scale; /* a point z / scale; prices or a direction */
    mpz_t part;
    mpz_t entry[COLUMNS], gain[COLUMNS]; /* of a step: a row of the basis, what columns bring */
};

/* z / scale: the solution whose unknowns that are no pivots are near `at`, in units of their
 * columns in doubles, or 0 where that is no number, or a very large one; where it is 1, at their
 * high end. */
bool study_basis_solve_point(study_proposer *w, const study_meeting *s, const double *at);
/* y / divisor: prices of the rows that make each pivot worth w->e.x[its place]. */
bool study_basis_solve_prices(study_proposer *w, const study_meeting *s);
/* The same for that form. */
bool study_basis_solve_form(study_proposer *w, const study_meeting *s, const study_form *f);
/* gain := divisor times the form less y M, with the prices at hand; 0 where f is NULL. */
void study_basis_find_gains(study_proposer *w, const study_meeting *s, const study_form *f);

/* Place of a pivot that is outside of its range at the point at hand, or -1; *high: it is above. */
int study_basis_place_outside(const study_proposer *w, bool *high);
/* One step of the dual simplex method, from the point and the gains at hand. False: there is none.
 */
bool study_basis_step_into_range(study_proposer *w, const study_meeting *s, int place, bool high);
/* One step of the primal simplex method, from the same. False: no column gains, or nothing stops
 * it. */
bool study_basis_step_to_end(study_proposer *w, const study_meeting *s);

#endif
