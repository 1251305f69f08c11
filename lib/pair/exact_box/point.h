/* point.h: a basic solution, in doubles with an error bound, and in integers as far as it is
 * needed.
 *
 * For each simplex one of its basic unknowns, the reference, is written as 1 less the others of its
 * simplex, whose columns and costs count relative to those of the reference; what is left are as
 * many equations P x = rest as there are basic unknowns, solved by Cramer's rule. All signs are
 * taken from doubles, as far as these tell them, and from integers where they do not.
 */
#ifndef FMB_PAIR_POINT_H
#define FMB_PAIR_POINT_H

#include "pair/exact_box/exact_box_program.h"

#define FMB_LANES 1
#include "pair/kernels/lane/double_double.h"

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
    fmb_extreme_near near_entry[FMB_EXTREME_UNKNOWNS]
                               [FMB_EXTREME_DIM]; /* [unknown][row], relative */
    fmb_extreme_near near_adjugate[FMB_EXTREME_DIM][FMB_EXTREME_DIM];
    fmb_extreme_near near_det, near_x[FMB_EXTREME_DIM], near_reference[2];
    /* The same exactly, as far as it was needed: the bits say what is there. */
    unsigned has_row, has_x;
    bool has_det, has_rest;
    fmb_wide adjugate[FMB_EXTREME_DIM][FMB_EXTREME_DIM], rest[FMB_EXTREME_DIM];
    fmb_wide det, x[FMB_EXTREME_DIM];
    /* The same in double-doubles, as far as exact_box_value.c needed it. */
    unsigned has_close;
    lane2 close_basic[FMB_EXTREME_DIM][FMB_EXTREME_DIM]; /* [k][row], relative */
    lane2 close_det, close_rest[FMB_EXTREME_DIM], close_x[FMB_EXTREME_DIM];
} fmb_extreme;

/* Stand there. False: these columns are no basis, or not all unknowns are in their places. */
bool fmb_extreme_stand(fmb_extreme *v, const fmb_extreme_program *s,
                       const fmb_extreme_basis *basis);
/* Roughly, the values of all columns. True: they are off by at most 2^-42. */
bool fmb_extreme_near_values(const fmb_extreme *v, double *z);

/* ---- for certify.c --------------------------------------------------------------------------- */

/* The basis alone. False: not as many unknowns are basic as there are equations. */
bool fmb_extreme_take_basis(fmb_extreme *v, const fmb_extreme_program *s,
                            const fmb_extreme_basis *basis);
/* Row k of the adjugate, det, x_k exactly. */
void fmb_extreme_need_row(fmb_extreme *v, int k);
void fmb_extreme_need_det(fmb_extreme *v);
void fmb_extreme_need_x(fmb_extreme *v, int k);
int fmb_extreme_sign_of_det(fmb_extreme *v);

extern const fmb_extreme_number fmb_extreme_zero, fmb_extreme_one;

/* a - b */
typedef struct fmb_extreme_relative {
    const fmb_extreme_number *a, *b;
} fmb_extreme_relative;

/* Entry of the column of unknown j. */
fmb_extreme_relative fmb_extreme_relative_entry(const fmb_extreme *v, int j, int row);

/* The reference that unknown j is relative to, or -1. */
static inline int fmb_extreme_reference_of(const fmb_extreme *v, int j)
{
    int group = v->program->group[j];
    return group <= FMB_EXTREME_OF_B ? v->reference[group] : -1;
}

static inline fmb_extreme_near fmb_extreme_near_difference(fmb_extreme_relative x)
{
    return (fmb_extreme_near){x.a->near - x.b->near, fabs(x.a->near) + fabs(x.b->near)};
}

/* sum += a b */
static inline void fmb_extreme_add_product(fmb_extreme_near *sum, fmb_extreme_near a,
                                           fmb_extreme_near b)
{
    sum->x += a.x * b.x;
    sum->size += a.size * b.size;
}

/* What has no size is 0. */
static inline bool fmb_extreme_is_sign_known(fmb_extreme_near a)
{
    return fabs(a.x) > 0x1p-47 * a.size || a.size == 0;
}

static inline int fmb_extreme_sign_of_near(fmb_extreme_near a)
{
    return (a.x > 0) - (a.x < 0);
}

/* Does the column of unknown j stand in the equations once, whatever the basic unknowns are? */
static inline bool fmb_extreme_is_one(const fmb_extreme *v, int j)
{
    return v->basis.place[j] == FMB_EXTREME_HIGH || j == v->reference[0] || j == v->reference[1];
}

/* It lies at x->a, or in *room. */
static inline const fmb_wide *fmb_extreme_difference(fmb_extreme_relative x, fmb_wide *room)
{
    if (x.b->whole.n == 0)
        return &x.a->whole;
    fmb_wide_copy(room, &x.a->whole);
    fmb_wide_subtract(room, &x.b->whole);
    return room;
}

#endif
