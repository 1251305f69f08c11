/* workspace.h: data shared by the files of pair/general; see general_decide.c.
 *
 * The frames A and B have a common point iff M z = h for unknowns z = (c of A, c of B, t) within
 * their bounds, with M = [axes of A, - axes of B, speed of A - speed of B] and h = origin of B -
 * origin of A. Each world coordinate is scaled by its own power of two, so that the largest entry
 * of each row of M is between 1/2 and 1 (of h, if the row of M is 0). So an entry has a relative
 * error of at most u = 2^-53 where it is a difference, and an absolute one of 2^-1074 where scaling
 * loses bits below the least double.
 */
#ifndef FMB_PAIR_GENERAL_WORKSPACE_H
#define FMB_PAIR_GENERAL_WORKSPACE_H

#include "lp/simplex/bounded/bounded_simplex.h"
#include "num/kernels/kernels.h"
#include "pair/general/general.h"

enum {
    FMB_GENERAL_MOST_DIM = 24,
    FMB_GENERAL_MOST_ROWS = FMB_GENERAL_MOST_DIM + 2, /* of a system */
    FMB_GENERAL_MOST_COLUMNS = 2 * FMB_GENERAL_MOST_DIM + 3
};

/* The bounds of an unknown: 0 <= z <= 1; in the simplex of A or of B; or only 0 <= z, as a row of M
 * bounds the sum. */
typedef enum fmb_general_kind {
    FMB_GENERAL_UNIT,
    FMB_GENERAL_OF_A,
    FMB_GENERAL_OF_B,
    FMB_GENERAL_SUMMED,
    FMB_GENERAL_KINDS
} fmb_general_kind;

/* M z = h, and an inverse R of the columns of some unknowns, the pivots. */
typedef struct fmb_general_system {
    int rows, columns;
    fmb_general_kind kind[FMB_GENERAL_MOST_COLUMNS];
    double *m;                        /* [columns][rows] */
    double *h;                        /* [rows] */
    const double *inverse;            /* [rows][rows] R */
    int pivot[FMB_GENERAL_MOST_ROWS]; /* [rows] column of row i */
    bool is_pivot[FMB_GENERAL_MOST_COLUMNS];
} fmb_general_system;

/* Row i of R. */
static inline const double *fmb_general_inverse(const fmb_general_system *s, int i)
{
    return s->inverse + (size_t)i * (size_t)s->rows;
}

struct fmb_general {
    int dim;
    const fmb_kernels *kernels;

    fmb_general_system pair; /* without pivots */

    /* linear programs: the pair with a slack for the sum of each simplex */
    fmb_general_system program;
    fmb_basis basis;                                             /* of its columns */
    double edges[FMB_GENERAL_MOST_ROWS * FMB_GENERAL_MOST_ROWS]; /* [rows][rows] inverse of basis */
    double vertex[FMB_GENERAL_MOST_COLUMNS];

    /* results */
    double direction[FMB_GENERAL_MOST_DIM]; /* of a clash */
    double z[FMB_GENERAL_MOST_COLUMNS];
};

typedef enum fmb_general_step {
    FMB_GENERAL_GO,
    FMB_GENERAL_CLASH, /* with a direction */
    FMB_GENERAL_LOST   /* failed by rounding */
} fmb_general_step;

/* general_decide.c: load the pair, scaled. False if differences or scaled numbers overflow. */
bool fmb_general_load(fmb_general *g, const fmb_frame *p, const fmb_frame *q);

/* general_program.c: find a first vertex of the pair. LOST, too, if the columns do not span all
 * rows: then the basis is incomplete. */
fmb_general_step fmb_general_find_vertex(fmb_general *g);
/* Walk from a vertex to one that maximizes cost z; y: the prices of M's rows. False if lost. */
bool fmb_general_maximize(fmb_general *g, const double *cost, double *y);
/* Find a point away from all bounds, starting at a vertex. False if there seems to be none. */
bool fmb_general_find_inside(fmb_general *g, double *z);

/* prove.c: are the closed frames certainly apart in that direction? */
bool fmb_general_are_apart(const fmb_general_system *s, const double *direction);
/* Is there certainly a solution near z, strictly inside both frames? */
bool fmb_general_is_near_common(const fmb_general_system *s, const double *z);

/* Is there certainly a solution near z, inside both frames, whose nonbasic unknowns are at their
 * bounds? */
bool fmb_general_is_near_vertex(const fmb_general_system *s, const double *z);
/* Certain bounds: cost z is at most *most in the whole program, and at a solution near the vertex
 * at least *most - *gap. |cost_j| <= 1. False if nothing is known. */
bool fmb_general_bound_cost(const fmb_general *g, const double *cost, const double *y, double *most,
                            double *gap);

#endif
