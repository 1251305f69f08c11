/* certify.h: is a basic solution common to both frames, and is a goal at its end there? Certainly.
 *
 * For each simplex one of its basic unknowns, the reference, is written as 1 less the others of its
 * simplex, whose columns and costs count relative to those of the reference; what is left are as
 * many equations P x = rest as there are basic unknowns, solved by Cramer's rule. All signs are
 * taken from doubles, as far as these tell them, and from integers where they do not.
 */
#ifndef FMB_PAIR_EXTREME_CERTIFY_H
#define FMB_PAIR_EXTREME_CERTIFY_H

#include "pair/extreme/program.h"

/* A number, off by at most 2^-47 of its size. */
typedef struct fmb_extreme_near {
    double x, size;
} fmb_extreme_near;

typedef struct fmb_extreme {
    const fmb_extreme_program *program;
    fmb_extreme_basis basis;
    int basic[FMB_EXTREME_DIM];
    int reference[2]; /* of each simplex, or -1 */
    int side;         /* the frame whose coordinates make a world coordinate from fewer unknowns */
    /* Values of basic unknowns are x / det, x = adjugate rest; likewise those of references. */
    fmb_extreme_near near_column[FMB_EXTREME_DIM][FMB_EXTREME_DIM];
    fmb_extreme_near near_adjugate[FMB_EXTREME_DIM][FMB_EXTREME_DIM];
    fmb_extreme_near near_det, near_x[FMB_EXTREME_DIM], near_reference[2];
    /* The same exactly, as far as it was needed: the bits say what is there. */
    unsigned has_row, has_x;
    bool has_det, has_rest;
    fmb_wide adjugate[FMB_EXTREME_DIM][FMB_EXTREME_DIM], rest[FMB_EXTREME_DIM];
    fmb_wide det, x[FMB_EXTREME_DIM];
} fmb_extreme;

/* Stand there. False: these columns are no basis, or not all unknowns are in their places. */
bool fmb_extreme_stand(fmb_extreme *v, const fmb_extreme_program *s,
                       const fmb_extreme_basis *basis);
/* Is the goal nowhere in M z = h, z in its places, farther out than here? */
bool fmb_extreme_is_farthest(fmb_extreme *v, const fmb_extreme_goal *goal);
/* The value of the goal here as a fraction, denominator > 0, in the unit of its row if it is one of
 * the world. */
void fmb_extreme_value(fmb_extreme *v, const fmb_extreme_goal *goal, fmb_wide *numerator,
                       fmb_wide *denominator);
/* Roughly, the values of all columns. */
void fmb_extreme_near_values(const fmb_extreme *v, double *z);

#endif
