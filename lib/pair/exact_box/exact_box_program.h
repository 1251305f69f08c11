/* exact_box_program.h: the common points of two frames as a linear program in short integers.
 *
 * The common points of A and B at time t correspond to unknowns z = (c of A, c of B, t) within
 * their bounds ("places") with M z = h, where M = [axes of A, - axes of B, speed of A - speed of B]
 * and h = origin of B - origin of A; the point is x = origin of A + (axes of A, 0, speed of A) z.
 * Each row, a coordinate of the world, has a unit of its own, so that all its numbers are integers.
 * The doubles nearest to them are scaled by a power of two, so that the largest in a row of M and h
 * is between 1/2 and 1.
 *
 * The places: 0 <= z <= 1 for an unknown of a cuboid or time; z >= 0 and sum z <= 1 for those of a
 * simplex. Each simplex has one more unknown, its slack 1 - sum z, so that all of its unknowns, the
 * barycentric coordinates, are alike. Each row has an artificial unknown, whose column is a unit
 * vector and whose place is 0: so there is a basis of unit vectors, and M may have any rank.
 *
 * If one frame is so much smaller than the other that doubles would take it for a point, each frame
 * has its own unit of unknowns: a long common divisor of all numbers in the columns of a frame is
 * divided out, and is then the upper end of its places instead of 1.
 *
 * In a basic solution each nonbasic unknown is at an end of its place. The number of basic unknowns
 * is that of the rows plus that of the simplices.
 */
#ifndef FMB_PAIR_EXACT_BOX_PROGRAM_H
#define FMB_PAIR_EXACT_BOX_PROGRAM_H

#include <fmb/gmp.h>

#include "pair/exact_box/wide.h"

enum {
    FMB_EXACT_BOX_DIM = 8, /* the most dimensions */
    FMB_EXACT_BOX_COLUMNS = 2 * FMB_EXACT_BOX_DIM + 1,
    FMB_EXACT_BOX_UNKNOWNS = FMB_EXACT_BOX_COLUMNS + 2 + FMB_EXACT_BOX_DIM
};

/* The groups of unknowns. */
enum {
    FMB_EXACT_BOX_OF_A,
    FMB_EXACT_BOX_OF_B,
    FMB_EXACT_BOX_UNIT,
    FMB_EXACT_BOX_ZERO,
    FMB_EXACT_BOX_NONE
};

/* A vector of integers; their scaled double-double approximations near + rest, with a relative
 * error of at most 2^-102. */
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
    /* The upper ends of the places of unknowns of A, of B, of time; and these in doubles, where
     * each group, and h, may have its own scale by a power of two; INFINITY: too large. */
    fmb_wide end[3];
    double near_end[3];
    bool has_ends; /* false: all ends are 1, and there are no such scales */
    /* An integer x of row i stands for x / unit_i: unit_i is 2^exponent[i], or unit[i] if numbers
     * are rationals. It is 2^scale[i] times its scaled double. */
    int exponent[FMB_EXACT_BOX_DIM], scale[FMB_EXACT_BOX_DIM];
} fmb_exact_box_program;

/* Can frames of so many dimensions and axes be loaded? */
static inline bool fmb_exact_box_is_for(int dim, int naxes_p, int naxes_q)
{
    return dim <= FMB_EXACT_BOX_DIM && naxes_p <= dim && naxes_q <= dim;
}

/* False: numbers of a row are too far apart, or fmb_exact_box_is_for is false. All numbers are
 * finite. */
bool fmb_exact_box_load(fmb_exact_box_program *s, const fmb_frame *p, const fmb_frame *q);
/* Like the function above, for rationals; unit[0 .. dim) are initialised. */
bool fmb_exact_box_load_q(fmb_exact_box_program *s, const fmb_frame_q *p, const fmb_frame_q *q,
                          mpq_t *unit);

/* The index in `end` of the upper end of unknown j's place. */
static inline int fmb_exact_box_end_of(const fmb_exact_box_program *s, int j)
{
    if (j >= s->slack)
        return j < s->artificial ? j - s->slack : 2;
    return j == s->time ? 2 : j >= s->first_of_b;
}

/* a += b times the upper end of unknown j's place; or a -= that. */
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

/* A goal: the least or greatest value of an unknown, or of a world coordinate. */
typedef struct fmb_exact_box_goal {
    bool is_world;
    int number; /* of the unknown, of the coordinate */
    bool greatest;
} fmb_exact_box_goal;

#endif
