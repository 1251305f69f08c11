/* normal_search.h: between the files of the least overlap: all normals of facets, choice by choice.
 *
 * Minors of the directions chosen are there in doubles and, where these do not tell, in whole
 * numbers.
 *
 * Numbers are short where they can be: what all share of a coordinate is no part of it, and what
 * all numbers of a direction share is no part of that one. In doubles each direction is scaled so
 * that none of its numbers is larger than 1, and has its length beside it. Let size(S) be the sum
 * of all products that make up the minor of rows S, without signs, and 2^-900. A number read
 * differs from the exact one by 2^-52 of itself, or by 2^-1074; a minor of k <= 7 rows sums k
 * products; so each level adds less than (k + 4) 2^-52 size(S) to the error, all of them less than
 * 2^-46 size(S), and FMB_NORMAL_SHARE is four times that. The overlap is a sum of less than 30
 * products of coordinates of the normal and numbers of the frames, whose sum without signs is
 * `weight`; twice FMB_NORMAL_SHARE bounds what they are off by. The surplus is far more than these
 * bounds themselves are rounded by.
 */
#ifndef FMB_PROXIMITY_NORMAL_SEARCH_H
#define FMB_PROXIMITY_NORMAL_SEARCH_H

#include <fmb/proximity.h>

#include "proximity/minkowski.h"
#include "proximity/overlap.h"

#define FMB_NORMAL_SHARE 0x1p-44
#define FMB_NORMAL_LEAST 0x1p-900 /* far above what is lost where doubles end */

enum {
    FMB_NORMAL_MOST_DIRECTIONS = FMB_NORMALS_MOST_DIM * (FMB_NORMALS_MOST_DIM + 1) + 1 +
                                 FMB_NORMALS_MOST_DIM, /* edges, the drift, axes of the world */
    FMB_NORMAL_SETS = 1 << FMB_NORMALS_MOST_DIM
};

/* Edges of one side are chosen together if they belong to one group: those of a cuboid are one
 * group, those of a simplex that start at one corner. Those of Q are negated. */
typedef struct fmb_normal_direction {
    int side, group;                /* side 2: the drift; 3: the world */
    mpz_t *exact;                   /* [dim] times 2^-power */
    double x[FMB_NORMALS_MOST_DIM]; /* the same scaled ... */
    double length;                  /* ... by this share of the largest direction, or of `away` */
    mp_bitcnt_t power;
} fmb_normal_direction;

/* P, Q and the drift: M is `away` and a point of each, which is a sum of shares of its axes, of a
 * simplex of all of them no more than 1. */
typedef struct fmb_normal_summand {
    int axes, first; /* directions */
    bool simplex;
} fmb_normal_summand;

typedef struct fmb_normal_search {
    fmb_minkowski *m;
    fmb_norm norm;
    fmb_run *run;
    fmb_mem *mem;
    int directions; /* without those of the world, which follow */
    fmb_normal_direction direction[FMB_NORMAL_MOST_DIRECTIONS];
    fmb_normal_summand of[3];
    /* Coordinate j is 2^unit[j] as long as it is here; that of a normal is share[j] of the longest
     * there can be. */
    mp_bitcnt_t unit[FMB_NORMALS_MOST_DIM], coarsest;
    double share[FMB_NORMALS_MOST_DIM];
    /* Of the directions chosen, a set of k rows about k: minors, in whole numbers of the first
     * `known` directions alone, and sizes. */
    int chosen[FMB_NORMALS_MOST_DIM];
    double minor[FMB_NORMAL_SETS], size[FMB_NORMAL_SETS];
    mpz_t *exact; /* [sets] */
    int known;
    mpz_t *away; /* [dim] origin of P - origin of Q; scaled in near */
    double near[FMB_NORMALS_MOST_DIM];
    double weight[FMB_NORMALS_MOST_DIM]; /* the largest |coordinates| of M, scaled */
    double best;                         /* no less than the least overlap / size, scaled */
    fmb_least_overlap at;                /* the one at hand */
    mpz_t *cell;                         /* [cells] all numbers */
    size_t cells;
    mpz_t low, high, span[2], t, s;
} fmb_normal_search;

/* Doubles of all numbers, once the whole ones are there; directions are shortened. */
void fmb_normal_search_scale(fmb_normal_search *x);
/* Bounds for overlap and size of the normal at hand, and whether it has no less than the best. */
bool fmb_normal_is_surely_more(const fmb_normal_search *x, double *bound);

#endif
