/* scaled_program.h: a program in doubles, as a backend and its files see it (backend.h).
 *
 * Row i is multiplied by a power of two, so that its largest coefficient is from 1/2 to 1 and
 * numbers beyond doubles fit; so is column j, if coefficients differ much: x_j = 2^-e x'_j, e its
 * exponent. Right sides, and with them points, are divided by a power of two of their own where
 * most are very long or very short: x = 2^unit x'. Rows are in the order of the program, including
 * those that are off, which do not count.
 */
#ifndef FMB_LP_SCALED_PROGRAM_H
#define FMB_LP_SCALED_PROGRAM_H

#include "lp/model/program.h"
#include "trace/run.h"

/* The index of an absent list entry. */
#define FMB_NOWHERE SIZE_MAX
/* Members of a basis are rows of the program, or FMB_UNIT + j: the row x_j = 0. */
#define FMB_UNIT (SIZE_MAX / 2)

typedef struct fmb_scaled_program {
    fmb_run *run;
    const fmb_program *p;
    size_t n, m;   /* columns; rows copied so far */
    size_t *start; /* [m + 1] where the terms of a row begin; their columns are the program's */
    double *value; /* [start[m]] */
    double *right; /* [m] the current ones, scaled like the rows and in units of 2^unit */
    int unit;
    int *exponent;        /* [m] the row was divided by 2^exponent */
    int *column_exponent; /* [n] likewise */
    bool *off;            /* [m] */
    size_t start_room, value_room, right_room, exponent_room, off_room;
    bool sharp; /* use the tightest tolerances */
} fmb_scaled_program;

/* Copy the rows of p. Errors: MEMORY, LIMIT; call fmb_scaled_program_clear even then. */
fmb_status fmb_scaled_program_init(fmb_scaled_program *f, fmb_run *run, const fmb_program *p);
void fmb_scaled_program_clear(fmb_scaled_program *f);
/* Copy the rows that the program got since. Errors: MEMORY, LIMIT. */
fmb_status fmb_scaled_program_grow(fmb_scaled_program *f);
/* Copy the next row of the program, which has no value: its terms are a[size], about 1. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_scaled_program_append(fmb_scaled_program *f, const double *a, double right);
/* Use the right sides right[m], of rows as they are in doubles (program.h), in unit 0; NULL: those
 * of the program, in a unit that fits. */
void fmb_scaled_program_shift(fmb_scaled_program *f, const double *right);
/* The right side of row i has changed in the program: copy it. */
void fmb_scaled_program_shift_row(fmb_scaled_program *f, size_t i);
/* Lower the right sides of inequalities by `by` times the sum of |coefficients|. */
void fmb_scaled_program_move_in(fmb_scaled_program *f, double by);
/* scaled[n] = cost[n] for the scaled columns, the largest about 1. False: not all are finite. */
bool fmb_scaled_program_scale_cost(const fmb_scaled_program *f, const double *cost, double *scaled);

static inline const int *fmb_scaled_program_columns(const fmb_scaled_program *f, size_t i)
{
    return f->p->row[i].column;
}
/* Are columns scaled, since coefficients differ much? */
bool fmb_scaled_program_has_scaled_columns(const fmb_scaled_program *f);
static inline bool fmb_scaled_program_is_equality(const fmb_scaled_program *f, size_t i)
{
    return f->p->row[i].rel == FMB_EQ;
}

#endif
