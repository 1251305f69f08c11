/* active_set.h: a search for rows that others imply, among few rows that are active.
 *
 * A row (a, b) is implied by others if it is a nonnegative combination of them and of (0, 1). Which
 * rows, and with which multipliers, is guessed in doubles (bounded_simplex.h), and proved in
 * integers (rounded_proof.h); where numbers are long, which rows is guessed, and multipliers are
 * solved for (combination.h). Only active rows are looked at: a row that they do not imply gives a
 * hyperplane, the row that lies farthest beyond it becomes active, and the search goes on (Clarkson
 * 1994).
 *
 * A search tests some rows and looks at all; several may go on at a time, each with what it finds
 * out. Invariant: a proof names no row that was gone in the search when it was found.
 */
#ifndef FMB_LP_ACTIVE_SET_H
#define FMB_LP_ACTIVE_SET_H

#include "lp/linalg/exact/combination.h"
#include "lp/oracle/refined_farkas.h"
#include "lp/redundancy/active_set/leading_rows.h"
#include "lp/redundancy/active_set/rounded_proof.h"
#include "lp/simplex/bounded/basis.h"

/* The rows, for all searches to look at. */
typedef struct fmb_scaled_rows {
    size_t n, m, d; /* columns, rows, columns with the right side */
    const fmb_lp_row *row;
    bool small;                      /* all rows are (num/vec.h) */
    const fmb_leading_rows *leading; /* names the columns, and has their units */
    size_t width;                    /* of the rows as they are */
    double *at;                      /* [d][m] rows, scaled */
    int *exponent;      /* [m] entry k of a row is 2^(exponent + leading->shift[k]) times that */
    fmb_program sparse; /* long rows */
} fmb_scaled_rows;

/* m rows of n columns, of which leading says which are named. Errors: MEMORY, LIMIT. In
 * any case fmb_scaled_rows_clear it. */
fmb_status fmb_scaled_rows_init(fmb_scaled_rows *s, fmb_mem *mem, size_t n, size_t m,
                                const fmb_lp_row *row, bool small, const fmb_leading_rows *leading);
void fmb_scaled_rows_clear(fmb_scaled_rows *s, fmb_mem *mem);

typedef struct fmb_active_set {
    fmb_run *run;
    const fmb_scaled_rows *of;
    const fmb_interior_point *seen; /* NULL: no point strictly inside is known */
    bool *gone, *kept;              /* [m] what is known so far */
    double *target, *price;         /* [d], [m] */
    double *way, *speed;            /* [n], [m] of rays */
    size_t *number;                 /* [m] of the row's generator, SIZE_MAX: inactive */
    size_t *source; /* [m + 1] row of a generator; m: the unit vector of the right side */
    size_t generators, inactive;
    fmb_basis cone;
    fmb_rounded_proof proof;     /* of small rows */
    fmb_combination combination; /* of long ones */
    size_t *support;             /* [supports], of at most d, rows that are combined */
    size_t supports;
    size_t *proved; /* [told] each proof: row, number of rows that it names, those */
    size_t told, proved_room;
    bool pauses;     /* testing may end where a slice of the run is over, */
    bool paused;     /* and did so: the next call goes on from there */
    size_t tested;   /* of the rows that are open so many have been tested, */
    bool again;      /* of those that were activated, once more */
    size_t doubtful; /* rows that seemed to be implied, but whose multipliers were not found */
} fmb_active_set;

/* All rows are inactive, none is gone or kept. Errors: MEMORY, LIMIT. In any case
 * fmb_active_set_clear it. */
fmb_status fmb_active_set_init(fmb_active_set *s, fmb_run *run, const fmb_scaled_rows *of,
                               const fmb_interior_point *seen);
void fmb_active_set_clear(fmb_active_set *s);
/* From the point inside shoot at rows from, ..., to - 1: what is hit is kept. Errors: LIMIT. */
fmb_status fmb_active_set_shoot(fmb_active_set *s, size_t from, size_t to);
/* Test the rows open[from], ..., open[to - 1]: those that others imply go. The rows kept so far are
 * activated, and equalities. With the same rows until it is not paused. Errors: MEMORY, LIMIT. */
fmb_status fmb_active_set_test(fmb_active_set *s, const size_t *open, size_t from, size_t to);

#endif
