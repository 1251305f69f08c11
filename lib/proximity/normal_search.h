/* normal_search.h: shared by the files of the least overlap: enumeration of the normals of facets.
 *
 * For most normals doubles prove that the overlap along them is not the least (rough_overlap.c);
 * the others are computed as integers, from minors of the chosen directions. These are kept short:
 * coordinates and directions are divided by the powers of 2 that all their numbers share.
 */
#ifndef FMB_PROXIMITY_NORMAL_SEARCH_H
#define FMB_PROXIMITY_NORMAL_SEARCH_H

#include <fmb/proximity.h>

#include "proximity/minkowski.h"
#include "proximity/overlap.h"

enum {
    FMB_NORMAL_MOST_DIRECTIONS = FMB_NORMALS_MOST_DIM * (FMB_NORMALS_MOST_DIM + 1) + 1 +
                                 FMB_NORMALS_MOST_DIM, /* edges, drift, world axes */
    FMB_NORMAL_COLUMNS = 3 * FMB_NORMALS_MOST_DIM + 2  /* axes, drift, away, coordinates */
};

/* Edges of one frame may be chosen together if they are in one group: all edges of a cuboid, or the
 * edges of a simplex at one corner. Those of Q are negated. */
typedef struct fmb_normal_direction {
    int side, group, end; /* side 2: the drift; 3: the world; `end`: the end corner */
    int from, to;         /* columns: `to` less `from`, or `to` alone if from is -1 */
    mpz_t *exact;         /* [dim] times 2^-power */
    mp_bitcnt_t power;
} fmb_normal_direction;

/* M is `away` plus the sum of three sets: P, Q (negated) and the drift, each the points sum c_i
 * axis_i with 0 <= c_i <= 1, and sum c_i <= 1 for a simplex. */
typedef struct fmb_normal_summand {
    int axes, first; /* directions */
    bool simplex;
} fmb_normal_summand;

/* The rows left by elimination of the chosen directions, with bounds of each row's numbers and of
 * their errors. */
typedef struct fmb_normal_rest {
    double x[FMB_NORMALS_MOST_DIM][FMB_NORMAL_COLUMNS], most[FMB_NORMALS_MOST_DIM],
        off[FMB_NORMALS_MOST_DIM];
} fmb_normal_rest;

/* Bounds of overlap / size, in the units of the doubles. */
typedef struct fmb_normal_bounds {
    double low, high;
} fmb_normal_bounds;

typedef struct fmb_normal_search {
    fmb_minkowski *m;
    fmb_norm norm;
    fmb_run *run;
    fmb_mem *mem;
    int directions; /* without world axes, which follow */
    fmb_normal_direction direction[FMB_NORMAL_MOST_DIRECTIONS];
    fmb_normal_summand of[3];
    /* Coordinates j are stored divided by 2^unit[j]. */
    mp_bitcnt_t unit[FMB_NORMALS_MOST_DIM], coarsest;
    int chosen[FMB_NORMALS_MOST_DIM];
    mpz_t
        *exact; /* [sets] minors of the first `known` chosen directions, by sets of `known` rows */
    int known;
    mpz_t *away; /* [dim] origin of P - origin of Q */
    /* The doubles: rows by the number of chosen directions; column c was divided by length[c],
     * number j of a normal is to be multiplied by share[j], and overlaps in doubles by 2^scale. */
    fmb_normal_rest rest[FMB_NORMALS_MOST_DIM];
    double length[FMB_NORMAL_COLUMNS], share[FMB_NORMALS_MOST_DIM];
    long scale;
    /* The least overlap known. If it waits, it belongs to the choice `waiting`, and is not computed
     * in integers yet. */
    fmb_normal_bounds best;
    bool waits;
    int waiting[FMB_NORMALS_MOST_DIM];
    fmb_least_overlap at; /* the present choice */
    mpz_t *cell;          /* [cells] all numbers */
    size_t cells;
    mpz_t low, high, span[2], t, s;
} fmb_normal_search;

/* Set up the doubles from the integers; directions are divided by their powers of 2. */
void fmb_normal_search_scale(fmb_normal_search *x);
/* Make `least`, computed in integers, the least overlap known. */
void fmb_normal_search_take(fmb_normal_search *x, const fmb_least_overlap *least);
/* Do doubles prove that the direction after the first `chosen` ones is independent of these? They
 * must have proved the same for each of these. */
bool fmb_normal_is_independent(fmb_normal_search *x, int chosen);
/* If doubles proved all chosen directions independent: is the overlap along their normal surely
 * more than the least known? Bounds of it. */
bool fmb_normal_is_surely_more(const fmb_normal_search *x);
fmb_normal_bounds fmb_normal_bound(const fmb_normal_search *x);

#endif
