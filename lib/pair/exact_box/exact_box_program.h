/* exact_box_program.h: where two frames meet, as a linear program in integers of a few words.
 *
 * The points that A and B have in common at time t are those of unknowns z = (c of A, c of B, t) in
 * their places with M z = h, where M = [axes of A, - axes of B, speed of A - speed of B] and h =
 * origin of B - origin of A; such a point is x = origin of A + (axes of A, 0, speed of A) z. Each
 * row, a coordinate of the world, is in units of its own, so that all numbers in it are integers.
 * Doubles next to them are scaled by a power of two, so that the largest in a row of M and h is
 * between 1/2 and 1.
 *
 * The places: 0 <= z <= 1 of a unit; for each simplex z >= 0 and sum z <= 1. To each simplex
 * belongs one unknown more, its slack 1 - sum z: so all of its unknowns, the barycentric
 * coordinates, are alike. And for each row there is an artificial unknown, whose column is a unit
 * vector and whose place is 0: so there is a basis of unit vectors, and M may have any rank.
 *
 * Where one frame is so much smaller than the other that doubles would take it for a point, each
 * has unknowns in units of their own: what all numbers in the columns of a frame have in common,
 * which is long, is taken out of them, and its places end there, and not at 1.
 *
 * In a basic solution each unknown that is not basic is at an end of its place. Basic are as many
 * as there are rows, and one more for each simplex.
 */
#ifndef FMB_PAIR_EXACT_BOX_PROGRAM_H
#define FMB_PAIR_EXACT_BOX_PROGRAM_H

#include <fmb/gmp.h>

#include "pair/exact_box/wide.h"

enum {
    FMB_EXACT_BOX_DIM = 8, /* the most there may be */
    FMB_EXACT_BOX_COLUMNS = 2 * FMB_EXACT_BOX_DIM + 1,
    FMB_EXACT_BOX_UNKNOWNS = FMB_EXACT_BOX_COLUMNS + 2 + FMB_EXACT_BOX_DIM
};

/* Which group an unknown is in. */
enum {
    FMB_EXACT_BOX_OF_A,
    FMB_EXACT_BOX_OF_B,
    FMB_EXACT_BOX_UNIT,
    FMB_EXACT_BOX_ZERO,
    FMB_EXACT_BOX_NONE
};

/* A vector of whole numbers; scaled, the doubles next to them, and what these are less, off by at
 * most 2^-102 of the numbers. */
typedef struct fmb_exact_box_vector {
    fmb_wide whole[FMB_EXACT_BOX_DIM];
    double near[FMB_EXACT_BOX_DIM], rest[FMB_EXACT_BOX_DIM];
} fmb_exact_box_vector;

typedef struct fmb_exact_box_program {
    int dim;
    /* Unknowns by number: columns of M, those of B from first_of_b on; from slack on the slacks of
     * both frames; from artificial on those of each row. time is -1 if nothing moves. */
    int columns, first_of_b, time, slack, artificial, unknowns;
    bool is_simplex[2];
    signed char group[FMB_EXACT_BOX_UNKNOWNS];      /* NONE: there is no such unknown */
    fmb_exact_box_vector m[FMB_EXACT_BOX_UNKNOWNS]; /* columns: of slacks they are 0 */
    fmb_exact_box_vector h;
    fmb_exact_box_vector origin[2], speed[2]; /* of A; of B, negative; speeds, if anything moves */
    /* Where places of unknowns of A, of B, of time end; and where they do in doubles, of which each
     * group, and h, may be scaled by powers of two of their own, too; INFINITY: beyond. */
    fmb_wide end[3];
    double near_end[3];
    bool has_ends; /* false: all are 1, and there are no such powers */
    /* A number x of row i is x / unit_i: 2^exponent[i], or unit[i] where numbers are rationals. It
     * is 2^scale[i] times the scaled one. */
    int exponent[FMB_EXACT_BOX_DIM], scale[FMB_EXACT_BOX_DIM];
} fmb_exact_box_program;

/* Can frames of so many dimensions and axes be loaded? */
static inline bool fmb_exact_box_is_for(int dim, int naxes_p, int naxes_q)
{
    return dim <= FMB_EXACT_BOX_DIM && naxes_p <= dim && naxes_q <= dim;
}

/* False: numbers of a row are too far apart, more than FMB_EXACT_BOX_DIM dimensions, more axes than
 * dimensions, which this is not for. All numbers are finite. */
bool fmb_exact_box_load(fmb_exact_box_program *s, const fmb_frame *p, const fmb_frame *q);
/* The same of rationals; unit[0 .. dim) are initialised. */
bool fmb_exact_box_load_q(fmb_exact_box_program *s, const fmb_frame_q *p, const fmb_frame_q *q,
                          mpq_t *unit);

/* Whose end of places is that of unknown j? */
static inline int fmb_exact_box_end_of(const fmb_exact_box_program *s, int j)
{
    if (j >= s->slack)
        return j < s->artificial ? j - s->slack : 2;
    return j == s->time ? 2 : j >= s->first_of_b;
}

/* a += b times where the place of unknown j ends, or a -= that. */
static inline void fmb_exact_box_gather_end(const fmb_exact_box_program *s, int j, fmb_wide *a,
                                            const fmb_wide *b, bool subtract)
{
    fmb_wide product;
    if (s->has_ends) {
        fmb_wide_multiply(&product, b, &s->end[fmb_exact_box_end_of(s, j)]);
        b = &product;
    }
    fmb_wide_gather(a, b, subtract);
}

/* ---- basic solutions ------------------------------------------------------------------------- */

typedef enum fmb_exact_box_place {
    FMB_EXACT_BOX_LOW,
    FMB_EXACT_BOX_HIGH,
    FMB_EXACT_BOX_BASIC
} fmb_exact_box_place;

typedef struct fmb_exact_box_basis {
    unsigned char place[FMB_EXACT_BOX_UNKNOWNS];
} fmb_exact_box_basis;

/* An unknown, or a coordinate of the world: which end of it is wanted. */
typedef struct fmb_exact_box_goal {
    bool is_world;
    int number; /* of the unknown, of the coordinate */
    bool greatest;
} fmb_exact_box_goal;

#endif
