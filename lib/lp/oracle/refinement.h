/* refinement.h: a row of a program as a combination of others, by multipliers that become as long
 * as their signs need (iterative refinement); they are never computed exactly.
 *
 * y B = c: B are rows, c is the odd row, both in the columns that they contain; y' is an
 * approximation of y, and rest = c - y' B is known exactly.
 */
#ifndef FMB_LP_REFINEMENT_H
#define FMB_LP_REFINEMENT_H

#include "lp/model/program.h"
#include "num/integers.h"
#include "trace/run.h"

typedef struct fmb_refinement {
    fmb_run *run;
    const fmb_program *p;
    size_t odd, m, n, size;   /* the row written as a combination; rows, columns of p; size of B */
    size_t *member, *column;  /* [size] rows of the basis, m + j: x_j = 0; and columns */
    size_t *at;               /* [n] the place of a column */
    int *exponent;            /* [size] rows are divided by 2^exponent */
    int odd_exponent, unit;   /* unit: the largest exponent */
    double *matrix, *inverse; /* [size][size] B and R */
    double *c, *y, *rest;     /* [size]; y: scratch */
    double *reach;            /* [size] sums of absolute values in rows of R */
    bool *is_nonzero;         /* [n] scratch */
    fmb_integers multiplier;  /* [size] y', in units of 2^-places */
    fmb_integers left;        /* [size] rest, in units of 2^-(places + unit) */
    int places;
    mpz_t term, entry;
} fmb_refinement;

/* For row `odd` of p, of whose rows the first m may be members. Errors: MEMORY, LIMIT; call
 * fmb_refinement_close even then. */
fmb_status fmb_refinement_open(fmb_refinement *t, fmb_run *run, const fmb_program *p, size_t m,
                               size_t odd);
void fmb_refinement_close(fmb_refinement *t);

/* B, its inverse R and c for those rows of basis[n] whose multipliers do not seem to be 0. *good:
 * they are as many as their columns, all of them rows, and |I - B R| <= 1/2. Errors: MEMORY, LIMIT.
 */
fmb_status fmb_refinement_of_basis(fmb_refinement *t, const size_t *basis, bool *good);
/* The same for exactly the rows row[size], size <= n. False: not good. */
bool fmb_refinement_of_rows(fmb_refinement *t, size_t size, const size_t *row);

/* rest = c - y' B, exactly in `left`, and in doubles. */
void fmb_refinement_find_rest(fmb_refinement *t);
/* Compute some more places of y', from the rest. */
void fmb_refinement_correct(fmb_refinement *t);

/* No multiplier differs from y' by more than this. */
double fmb_refinement_bound_error(const fmb_refinement *t);
/* The common sign of all multipliers of inequalities, 0 if there are none. False: not known yet, or
 * they *differ. */
bool fmb_refinement_common_sign(const fmb_refinement *t, double error, int *sign, bool *differ);
/* The sign of b_odd - sum_r y_r b_r, 0 if it is not known. Overwrites `left`. */
int fmb_refinement_sign_of_remainder(fmb_refinement *t, double error);

#endif
