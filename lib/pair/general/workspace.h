/* workspace.h: what the files of the general way share; see general_decide.c.
 *
 * The frames A and B have a point together iff M z = h for unknowns z = (c of A, c of B, t) in
 * their places, with M = [axes of A, - axes of B, speed of A - speed of B] and h = origin of B -
 * origin of A. Each world coordinate is scaled by a power of two of its own, so that the largest
 * entry of each row of M is between 1/2 and 1 (of h, if M has nothing but 0 there). So an entry is
 * off by at most u of itself, u = 2^-53, where it is a difference, and by 2^-1074 where scaling
 * loses bits below the least double.
 *
 * Some unknowns, the pivots, are solved for in terms of the others, the free ones:
 *
 *     z_pivot(i) + sum T_ij z_free(j) = r_i,      which is row i of R (M z - h) = 0
 *
 * The elimination is on rows low <= a x <= high; x are the free unknowns not yet removed. Each row
 * is known to be v (M z - h), for some v in R^D, in terms of x and of unknowns that their places
 * bound, and keeps that v. So a row that nothing in the box of x satisfies says that the frames are
 * apart in direction v.
 */
#ifndef FMB_PAIR_GENERAL_WORKSPACE_H
#define FMB_PAIR_GENERAL_WORKSPACE_H

#include "lp/simplex/simplex.h"
#include "num/kernels/kernels.h"
#include "pair/general/general.h"

enum {
    FMB_GENERAL_MOST_DIM = 24,                        /* base rows of a history fit into one word */
    FMB_GENERAL_MOST_ROWS = FMB_GENERAL_MOST_DIM + 2, /* of a system */
    FMB_GENERAL_MOST_COLUMNS = 2 * FMB_GENERAL_MOST_DIM + 3
};

/* The place of an unknown: 0 <= z <= 1; the simplex of A or of B; 0 <= z, and a row of M sees to
 * the sum. */
typedef enum fmb_general_kind {
    FMB_GENERAL_UNIT,
    FMB_GENERAL_OF_A,
    FMB_GENERAL_OF_B,
    FMB_GENERAL_SUMMED,
    FMB_GENERAL_KINDS
} fmb_general_kind;

/* M z = h, and an inverse R of the columns of the pivots. */
typedef struct fmb_general_system {
    int rows, columns;
    fmb_general_kind kind[FMB_GENERAL_MOST_COLUMNS];
    double *m;             /* [columns][rows] */
    double *h;             /* [rows] */
    const double *inverse; /* R, row i at inverse[i * stride] */
    int stride, rank;
    int pivot[FMB_GENERAL_MOST_ROWS]; /* [rows] column of row i, or -1 */
    bool is_pivot[FMB_GENERAL_MOST_COLUMNS];
} fmb_general_system;

/* Row i of R. */
static inline const double *fmb_general_inverse(const fmb_general_system *s, int i)
{
    return s->inverse + (size_t)i * (size_t)s->stride;
}

typedef struct fmb_general_head {
    double low, high; /* infinite: no such end */
    /* base rows that gave their upper ends to high (their lower ends to low), and base rows that
     * gave their lower ends to high (their upper ends to low) */
    uint64_t plus, minus;
} fmb_general_head;

/* The rows before a round. */
typedef struct fmb_general_level {
    size_t first, rows;
    int place; /* of the unknown that the round removed; the last one moved there */
} fmb_general_level;

struct fmb_general {
    int dim;
    const fmb_kernels *kernels;

    fmb_general_system pair;
    double *solved; /* [dim][stride of the pair]: T in the columns of M, r, R */

    /* the elimination */
    int n, removed;                        /* unknowns: left, removed */
    int unknown[FMB_GENERAL_MOST_COLUMNS]; /* column of the one at each place */
    bool all_unit;                         /* no free unknown is in a simplex */
    size_t rows, most_rows, pairs, stride;
    fmb_general_head *head; /* [most_rows] */
    double *cell;           /* [most_rows][stride]: v, then a */
    uint16_t *named;        /* [most_rows] rows with the unknown to be removed */
    uint64_t *bits, *drop;  /* their histories, side by side; which of them not to pair */
    fmb_general_level level[FMB_GENERAL_MOST_COLUMNS + 1];

    /* linear programs: the pair with a slack for the sum of each simplex */
    fmb_general_system program;
    fmb_basis basis;                                             /* of its columns */
    double edges[FMB_GENERAL_MOST_ROWS * FMB_GENERAL_MOST_ROWS]; /* [rows][rows] its inverse */
    double vertex[FMB_GENERAL_MOST_COLUMNS];

    /* what is found */
    double direction[FMB_GENERAL_MOST_DIM]; /* v of a clash */
    double z[FMB_GENERAL_MOST_COLUMNS];
};

static inline double *fmb_general_solved(const fmb_general *g, int i)
{
    return g->solved + (size_t)i * (size_t)g->pair.stride;
}

typedef enum fmb_general_step {
    FMB_GENERAL_GO,
    FMB_GENERAL_CLASH, /* with a direction */
    FMB_GENERAL_LOST   /* no room, or rounding has spoilt it */
} fmb_general_step;

static inline double *fmb_general_cell(const fmb_general *g, size_t i)
{
    return g->cell + i * g->stride;
}

/* general_decide.c: the pair, scaled. False if differences or scaled numbers overflow. */
bool fmb_general_load(fmb_general *g, const fmb_frame *p, const fmb_frame *q);

/* pivots.c: choose pivots and solve for them. */
void fmb_general_solve(fmb_general *g);

/* general_rows.c: the rows of the pair. */
fmb_general_step fmb_general_start(fmb_general *g);
/* Keep the row at the end, of n unknowns, without ends that say nothing in the box. */
fmb_general_step fmb_general_settle(fmb_general *g, int n);
/* Bring the unknown at that place of row i to the last place, and its coefficient to 1 (or 0). */
void fmb_general_turn(fmb_general *g, size_t i, int place);

/* rounds.c: rounds until at most two unknowns are left. */
fmb_general_step fmb_general_eliminate(fmb_general *g);

/* last_two.c: the last two, then z from all rows. */
fmb_general_step fmb_general_finish(fmb_general *g);

/* general_program.c: a first vertex of the pair. */
fmb_general_step fmb_general_find_vertex(fmb_general *g);
/* From a vertex to one where cost z is greatest; y are the prices of M's rows. False if lost. */
bool fmb_general_maximize(fmb_general *g, const double *cost, double *y);
/* A point away from all ends, from a vertex. False if there seems to be none. */
bool fmb_general_find_inside(fmb_general *g, double *z);

/* prove.c: are the closed frames certainly apart in that direction? */
bool fmb_general_are_apart(const fmb_general_system *s, const double *direction);
/* Is there certainly a solution near z, strictly inside both frames? */
bool fmb_general_is_near_common(const fmb_general_system *s, const double *z);

/* Is there certainly a solution near z, inside both frames, whose unknowns that are no pivots are
 * at an end? */
bool fmb_general_is_near_vertex(const fmb_general_system *s, const double *z);
/* cost z is certainly at most *most in the program, and at a solution near the vertex certainly at
 * least *most - *gap. |cost_j| <= 1. False if nothing is known. */
bool fmb_general_bound_cost(const fmb_general *g, const double *cost, const double *y, double *most,
                            double *gap);

#endif
