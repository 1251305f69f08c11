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
typedef struct fmb_exact_box_near {
    double x, size;
} fmb_exact_box_near;

typedef struct fmb_exact_box {
    const fmb_exact_box_program *program;
    fmb_exact_box_basis basis;
    int basic[FMB_EXACT_BOX_DIM];
    int reference[2]; /* of each simplex, or -1 */
    int side;         /* the frame whose coordinates make a world coordinate from fewer unknowns */
    /* Values of basic unknowns are x / det, x = adjugate rest; likewise those of references. */
    fmb_exact_box_near near_entry[FMB_EXACT_BOX_UNKNOWNS]
                                 [FMB_EXACT_BOX_DIM]; /* [unknown][row], relative */
    fmb_exact_box_near near_adjugate[FMB_EXACT_BOX_DIM][FMB_EXACT_BOX_DIM];
    fmb_exact_box_near near_det, near_x[FMB_EXACT_BOX_DIM], near_reference[2];
    /* The same exactly, as far as it was needed: the bits say what is there. */
    unsigned has_row, has_x;
    bool has_det, has_rest;
    fmb_wide adjugate[FMB_EXACT_BOX_DIM][FMB_EXACT_BOX_DIM], rest[FMB_EXACT_BOX_DIM];
    fmb_wide det, x[FMB_EXACT_BOX_DIM];
    /* The same in double-doubles, as far as exact_box_value.c needed it. */
    unsigned has_close;
    lane2 close_basic[FMB_EXACT_BOX_DIM][FMB_EXACT_BOX_DIM]; /* [k][row], relative */
    lane2 close_det, close_rest[FMB_EXACT_BOX_DIM], close_x[FMB_EXACT_BOX_DIM];
} fmb_exact_box;

/* Stand there. False: these columns are no basis, or not all unknowns are in their places. */
bool fmb_exact_box_state(fmb_exact_box *v, const fmb_exact_box_program *s,
                         const fmb_exact_box_basis *basis);
/* Roughly, the values of all columns. True: they are off by at most 2^-42. */
bool fmb_exact_box_near_values(const fmb_exact_box *v, double *z);

/* ---- for certify.c --------------------------------------------------------------------------- */

/* The basis alone. False: not as many unknowns are basic as there are equations. */
bool fmb_exact_box_take_basis(fmb_exact_box *v, const fmb_exact_box_program *s,
                              const fmb_exact_box_basis *basis);
/* Row k of the adjugate, det, x_k exactly. */
void fmb_exact_box_need_row(fmb_exact_box *v, int k);
void fmb_exact_box_need_det(fmb_exact_box *v);
void fmb_exact_box_need_x(fmb_exact_box *v, int k);
int fmb_exact_box_sign_of_det(fmb_exact_box *v);

extern const fmb_exact_box_number fmb_exact_box_zero, fmb_exact_box_one;

/* a - b */
typedef struct fmb_exact_box_relative {
    const fmb_exact_box_number *a, *b;
} fmb_exact_box_relative;

/* Entry of the column of unknown j. */
fmb_exact_box_relative fmb_exact_box_relative_entry(const fmb_exact_box *v, int j, int row);

/* The reference that unknown j is relative to, or -1. */
static inline int fmb_exact_box_reference_of(const fmb_exact_box *v, int j)
{
    int group = v->program->group[j];
    return group <= FMB_EXACT_BOX_OF_B ? v->reference[group] : -1;
}

static inline fmb_exact_box_near fmb_exact_box_near_difference(fmb_exact_box_relative x)
{
    return (fmb_exact_box_near){x.a->near - x.b->near, fabs(x.a->near) + fabs(x.b->near)};
}

/* sum += a b */
static inline void fmb_exact_box_add_product(fmb_exact_box_near *sum, fmb_exact_box_near a,
                                             fmb_exact_box_near b)
{
    sum->x += a.x * b.x;
    sum->size += a.size * b.size;
}

/* What has no size is 0. */
static inline bool fmb_exact_box_is_sign_known(fmb_exact_box_near a)
{
    return fabs(a.x) > 0x1p-47 * a.size || a.size == 0;
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

/* It lies at x->a, or in *room. */
static inline const fmb_wide *fmb_exact_box_difference(fmb_exact_box_relative x, fmb_wide *room)
{
    if (x.b->whole.n == 0)
        return &x.a->whole;
    fmb_wide_copy(room, &x.a->whole);
    fmb_wide_subtract(room, &x.b->whole);
    return room;
}

#endif
