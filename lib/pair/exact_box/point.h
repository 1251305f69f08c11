/* point.h: a basic solution, in doubles with an error bound, and in integers where these do not
 * tell.
 *
 * For each simplex one of its basic unknowns, the reference, is written as 1 less the others of its
 * simplex, whose columns and costs count relative to those of the reference; what is left are as
 * many equations P x = rest as there are dimensions. All signs are taken from doubles, as far as
 * these tell them, and from integers where they do not.
 */
#ifndef FMB_PAIR_POINT_H
#define FMB_PAIR_POINT_H

#include "base/poll.h"
#include "pair/exact_box/low_words.h"

#define FMB_LANES 1
#include "pair/kernels/lane/double_double.h"

/* A number, off by at most error. */
typedef struct fmb_exact_box_near {
    double x, error;
} fmb_exact_box_near;

enum {
    FMB_EXACT_BOX_ITEMS = FMB_EXACT_BOX_DIM + 2 /* basic unknowns, references among them */
};

/* The numbers of one basic solution exactly: P^-1 is adjugate / det, values of basic unknowns are
 * x / det. */
typedef struct fmb_exact_box_whole {
    const fmb_poll *poll; /* asked before each step in integers; NULL: nobody is */
    /* Whose det and x, det and adjugate, and low are, or NULL */
    const struct fmb_exact_box *of, *adjugate_of, *low_of;
    fmb_wide det; /* >= 0; 0: P has no inverse, and the others mean nothing */
    fmb_wide x[FMB_EXACT_BOX_DIM], adjugate[FMB_EXACT_BOX_DIM][FMB_EXACT_BOX_DIM];
    fmb_wide factor[FMB_EXACT_BOX_DIM]
                   [FMB_EXACT_BOX_DIM + 1]; /* of P with its rest, of det and x */
    int row[FMB_EXACT_BOX_DIM];             /* where each of its rows was */
    fmb_exact_box_low low;                  /* before signs are such that det >= 0 */
    /* Room for calculations: long numbers are too long for the stack of a small thread. */
    fmb_wide cost[FMB_EXACT_BOX_DIM], column[FMB_EXACT_BOX_DIM], price[FMB_EXACT_BOX_DIM];
    /* Of a walk; way: 1, 0 and -1, the way into its place of what is below, in, and above it. */
    fmb_wide value[FMB_EXACT_BOX_ITEMS], fall[FMB_EXACT_BOX_ITEMS], way[3];
} fmb_exact_box_whole;

/* Those of v, which is about to change, are no longer known. */
static inline void fmb_exact_box_forget_whole(fmb_exact_box_whole *w, const struct fmb_exact_box *v)
{
    w->of = w->of == v ? NULL : w->of;
    w->adjugate_of = w->adjugate_of == v ? NULL : w->adjugate_of;
    w->low_of = w->low_of == v ? NULL : w->low_of;
}

/* P^-1 is nearly inverse: the sum of what row k of inverse P is off a unit vector is at most
 * defect[k] < 1/2. */
typedef struct fmb_exact_box {
    const fmb_exact_box_program *program;
    fmb_exact_box_whole *whole; /* room for many */
    fmb_exact_box_basis basis;
    int basic[FMB_EXACT_BOX_DIM];
    int reference[2]; /* of each simplex, or -1 */
    int side;         /* the frame whose coordinates make a world coordinate from fewer unknowns */
    bool is_near;     /* is there such an inverse? */
    double inverse[FMB_EXACT_BOX_DIM][FMB_EXACT_BOX_DIM], defect[FMB_EXACT_BOX_DIM];
    double norm; /* no sum of the absolute values of a row of it is larger */
    fmb_exact_box_near x[FMB_EXACT_BOX_DIM], of_reference[2];
    bool has_close; /* x in double-doubles, as far as exact_box_value.c needed it */
    lane2 close_x[FMB_EXACT_BOX_DIM];
    double close_error[FMB_EXACT_BOX_DIM];
} fmb_exact_box;

/* Stand there. False: these columns are no basis, or not all unknowns are in their places. */
bool fmb_exact_box_state(fmb_exact_box *v, const fmb_exact_box_program *s,
                         const fmb_exact_box_basis *basis);
/* Is unknown j of a vertex, which is none of the artificial ones, off that end of its place? */
bool fmb_exact_box_is_off_end(fmb_exact_box *v, int j, bool high);
/* Roughly, the values of all columns and slacks, as doubles have them. True: they are off by at
 * most 2^-42, and places end at 1. */
bool fmb_exact_box_near_values(const fmb_exact_box *v, double *z);

/* ---- for certify.c, exact_walk.c and exact_box_value.c ----------------------------------------
 */

/* The basis alone, and what doubles tell of it. False: not as many unknowns are basic as there are
 * equations. */
bool fmb_exact_box_take_basis(fmb_exact_box *v, const fmb_exact_box_program *s,
                              const fmb_exact_box_basis *basis);
/* What an x that is off P x = rest by at most rest[row] in each (scaled) row is off by: error[k].
 */
void fmb_exact_box_bound_way(const fmb_exact_box *v, const double *rest, double *error);
/* Its values and det exactly, in v->whole; the adjugate and det. */
const fmb_exact_box_whole *fmb_exact_box_need_whole(fmb_exact_box *v);
fmb_exact_box_whole *fmb_exact_box_need_adjugate(fmb_exact_box *v);
/* det times c P^-1, for P that has an inverse; the numbers of c do not last. */
void fmb_exact_box_solve_transposed(fmb_exact_box *v, fmb_wide *c, fmb_wide *y);
/* The same modulo 2^128. */
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

/* a = (pivot a - b c) / det, or (pivot a + b c) / det: a whole number. */
static inline void fmb_exact_box_reduce(fmb_wide *a, const fmb_wide *pivot, const fmb_wide *b,
                                        const fmb_wide *c, bool plus, const fmb_wide *det)
{
    if (a->n == 0 && (b->n == 0 || c->n == 0))
        return;
    fmb_wide_dot(a, 2, (const fmb_wide *const[]){pivot, b}, (const fmb_wide *const[]){a, c},
                 plus ? 0 : 2);
    fmb_wide_divide_exactly(a, det);
}

/* det times where the place of x_only ends less x_only; where only is -1 that of the reference of a
 * group less all x of it. */
void fmb_exact_box_remainder(fmb_exact_box *v, int group, int only, fmb_wide *out);

/* The column of unknown j in integers, relative to that of its reference: each number lies in the
 * program, or in room. */
void fmb_exact_box_list_column(const fmb_exact_box *v, int j, const fmb_wide **out, fmb_wide *room);

/* The reference that unknown j is relative to, or -1. */
static inline int fmb_exact_box_reference_of(const fmb_exact_box *v, int j)
{
    int group = v->program->group[j];
    return group <= FMB_EXACT_BOX_OF_B ? v->reference[group] : -1;
}

/* Is its sign that of x? */
static inline bool fmb_exact_box_is_sign_known(fmb_exact_box_near a)
{
    return fabs(a.x) > a.error || a.error == 0;
}

static inline int fmb_exact_box_sign_of_near(fmb_exact_box_near a)
{
    return (a.x > 0) - (a.x < 0);
}

/* Does the column of unknown j stand in the equations once, whatever the basic unknowns are? */
static inline bool fmb_exact_box_is_one(const fmb_exact_box *v, int j)
{
    return v->basis.place[j] == FMB_EXACT_BOX_HIGH || j == v->reference[0] || j == v->reference[1];
}

/* a - b, at a, or in *room; b may be NULL. */
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
