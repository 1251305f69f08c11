/* point.h: a basic solution, in doubles with an error bound, and in integers where doubles are not
 * decisive.
 *
 * For each simplex one of its basic unknowns, the reference, is replaced by 1 minus the others of
 * its simplex, whose columns and costs become relative to those of the reference; this leaves as
 * many equations P x = rest as there are dimensions. Signs are taken from doubles where these are
 * certain, and from integers where they are not.
 */
#ifndef FMB_PAIR_POINT_H
#define FMB_PAIR_POINT_H

#include "base/poll.h"
#include "pair/exact_box/low_words.h"

#define FMB_LANES 1
#include "pair/kernels/lane/double_double.h"

/* A number with an absolute error of at most error. */
typedef struct fmb_exact_box_near {
    double x, error;
} fmb_exact_box_near;

enum {
    FMB_EXACT_BOX_ITEMS = FMB_EXACT_BOX_DIM + 2 /* basic unknowns, references among them */
};

/* The exact numbers of one basic solution: P^-1 is adjugate / det, values of basic unknowns are
 * x / det. */
typedef struct fmb_exact_box_whole {
    const fmb_poll *poll; /* called before each step in integers; NULL: none */
    /* The solution that det and x, det and adjugate, and low belong to; or NULL */
    const struct fmb_exact_box *of, *adjugate_of, *low_of;
    fmb_wide det; /* >= 0; 0: P has no inverse, and the others are undefined */
    fmb_wide x[FMB_EXACT_BOX_DIM], adjugate[FMB_EXACT_BOX_DIM][FMB_EXACT_BOX_DIM];
    fmb_wide factor[FMB_EXACT_BOX_DIM]
                   [FMB_EXACT_BOX_DIM + 1]; /* of P with its rest, of det and x */
    int row[FMB_EXACT_BOX_DIM];             /* where each of its rows was */
    fmb_exact_box_low low;                  /* before signs are such that det >= 0 */
    /* Room for calculations: long numbers are too long for the stack of a small thread. */
    fmb_wide cost[FMB_EXACT_BOX_DIM], column[FMB_EXACT_BOX_DIM], price[FMB_EXACT_BOX_DIM];
    /* Of a walk; way: 1, 0 and -1, the direction into its place for a value below, in, above it. */
    fmb_wide value[FMB_EXACT_BOX_ITEMS], fall[FMB_EXACT_BOX_ITEMS], way[3];
} fmb_exact_box_whole;

/* Forget the numbers of v, which is about to change. */
static inline void fmb_exact_box_forget_whole(fmb_exact_box_whole *w, const struct fmb_exact_box *v)
{
    w->of = w->of == v ? NULL : w->of;
    w->adjugate_of = w->adjugate_of == v ? NULL : w->adjugate_of;
    w->low_of = w->low_of == v ? NULL : w->low_of;
}

/* A basic solution. inverse approximates P^-1: row k of inverse P differs from a unit vector by at
 * most defect[k] < 1/2, in the sum of absolute values. */
typedef struct fmb_exact_box {
    const fmb_exact_box_program *program;
    fmb_exact_box_whole *whole; /* workspace shared by many */
    fmb_exact_box_basis basis;
    int basic[FMB_EXACT_BOX_DIM];
    int reference[2]; /* of each simplex, or -1 */
    int side;         /* the frame whose coordinates make a world coordinate from fewer unknowns */
    bool is_near;     /* inverse is valid */
    double inverse[FMB_EXACT_BOX_DIM][FMB_EXACT_BOX_DIM], defect[FMB_EXACT_BOX_DIM];
    double norm; /* the largest sum of absolute values of a row of inverse */
    fmb_exact_box_near x[FMB_EXACT_BOX_DIM], of_reference[2];
    bool has_close; /* x in double-doubles, as far as exact_box_value.c needed it */
    lane2 close_x[FMB_EXACT_BOX_DIM];
    double close_error[FMB_EXACT_BOX_DIM];
} fmb_exact_box;

/* Set v to this basis. False: these columns are no basis, or some unknown is not in its place. */
bool fmb_exact_box_state(fmb_exact_box *v, const fmb_exact_box_program *s,
                         const fmb_exact_box_basis *basis);
/* Is unknown j of a vertex, not an artificial one, away from that end of its place? */
bool fmb_exact_box_is_off_end(fmb_exact_box *v, int j, bool high);
/* Approximate values of all columns and slacks, in doubles. True: their errors are at most 2^-42,
 * and places end at 1. */
bool fmb_exact_box_near_values(const fmb_exact_box *v, double *z);

/* ---- for certify.c, exact_walk.c and exact_box_value.c ----------------------------------------
 */

/* Set the basis, and its numbers in doubles. False: the number of basic unknowns is not that of the
 * equations. */
bool fmb_exact_box_take_basis(fmb_exact_box *v, const fmb_exact_box_program *s,
                              const fmb_exact_box_basis *basis);
/* Bound the error of x: if its residual in P x = rest is at most rest[row] in each (scaled) row,
 * x_k has an error of at most error[k]. */
void fmb_exact_box_bound_way(const fmb_exact_box *v, const double *rest, double *error);
/* Compute values and det exactly, in v->whole. Below: the adjugate and det. */
const fmb_exact_box_whole *fmb_exact_box_need_whole(fmb_exact_box *v);
fmb_exact_box_whole *fmb_exact_box_need_adjugate(fmb_exact_box *v);
/* y = det times c P^-1, if P has an inverse; c is overwritten. */
void fmb_exact_box_solve_transposed(fmb_exact_box *v, fmb_wide *c, fmb_wide *y);
/* Compute det and values modulo 2^128. */
const fmb_exact_box_low *fmb_exact_box_need_low(fmb_exact_box *v);
/* Row k of the adjugate times a column. */
static inline void fmb_exact_box_times_row(const fmb_exact_box_whole *w, int n, int k,
                                           const fmb_wide *const *column, fmb_wide *out)
{
    const fmb_wide *row[FMB_EXACT_BOX_DIM];
    for (int i = 0; i < n; i++)
        row[i] = &w->adjugate[k][i];
    fmb_wide_dot(out, n, row, column, 0);
}

/* a = (pivot a - b c) / det, or (pivot a + b c) / det, which is an integer. */
static inline void fmb_exact_box_reduce(fmb_wide *a, const fmb_wide *pivot, const fmb_wide *b,
                                        const fmb_wide *c, bool plus, const fmb_wide *det)
{
    if (a->n == 0 && (b->n == 0 || c->n == 0))
        return;
    fmb_wide_dot(a, 2, (const fmb_wide *const[]){pivot, b}, (const fmb_wide *const[]){a, c},
                 plus ? 0 : 2);
    fmb_wide_divide_exactly(a, det);
}

/* det times (upper end of the place of x_only minus x_only); if only is -1, det times (the end of
 * the group's reference minus all x of the group). */
void fmb_exact_box_remainder(fmb_exact_box *v, int group, int only, fmb_wide *out);

/* The integer column of unknown j minus that of its reference: each pointer is into the program, or
 * into room. */
void fmb_exact_box_list_column(const fmb_exact_box *v, int j, const fmb_wide **out, fmb_wide *room);

/* The reference that unknown j is relative to, or -1. */
static inline int fmb_exact_box_reference_of(const fmb_exact_box *v, int j)
{
    int group = v->program->group[j];
    return group <= FMB_EXACT_BOX_OF_B ? v->reference[group] : -1;
}

/* Is the sign of the exact number certainly that of a.x? */
static inline bool fmb_exact_box_is_sign_known(fmb_exact_box_near a)
{
    return fabs(a.x) > a.error || a.error == 0;
}

static inline int fmb_exact_box_sign_of_near(fmb_exact_box_near a)
{
    return (a.x > 0) - (a.x < 0);
}

/* Is the column of unknown j part of the constant right side, with factor 1? */
static inline bool fmb_exact_box_is_one(const fmb_exact_box *v, int j)
{
    return v->basis.place[j] == FMB_EXACT_BOX_HIGH || j == v->reference[0] || j == v->reference[1];
}

/* a - b; returns a pointer to it, a or room; b may be NULL. */
static inline const fmb_wide *fmb_exact_box_difference(const fmb_wide *a, const fmb_wide *b,
                                                       fmb_wide *room)
{
    if (!b || b->n == 0)
        return a;
    fmb_wide_copy(room, a);
    fmb_wide_subtract(room, b);
    return room;
}

#endif
