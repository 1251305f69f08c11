/* normal_search.h: between the files of the least overlap: all normals of facets, choice by choice.
 *
 * Doubles tell of most normals that there is more overlap along them (rough_overlap.c); where they
 * do not, minors of the directions chosen in whole numbers do. These are short where they can be:
 * what all share of a coordinate is no part of it, and what all numbers of a direction share is no
 * part of that one.
 */
#ifndef FMB_PROXIMITY_NORMAL_SEARCH_H
#define FMB_PROXIMITY_NORMAL_SEARCH_H

#include <fmb/proximity.h>

#include "proximity/minkowski.h"
#include "proximity/overlap.h"

enum {
    FMB_NORMAL_MOST_DIRECTIONS = FMB_NORMALS_MOST_DIM * (FMB_NORMALS_MOST_DIM + 1) + 1 +
                                 FMB_NORMALS_MOST_DIM, /* edges, the drift, axes of the world */
    FMB_NORMAL_COLUMNS = 3 * FMB_NORMALS_MOST_DIM + 2  /* axes, drift, away, coordinates */
};

/* Edges of one side are chosen together if they belong to one group: those of a cuboid are one
 * group, those of a simplex that start at one corner. Those of Q are negated. */
typedef struct fmb_normal_direction {
    int side, group, end; /* side 2: the drift; 3: the world; `end` is the other corner */
    int from, to;         /* columns: it is `to` less `from`, or `to` alone if that is -1 */
    mpz_t *exact;         /* [dim] times 2^-power */
    mp_bitcnt_t power;
} fmb_normal_direction;

/* P, Q and the drift: M is `away` and a point of each, which is a sum of shares of its axes, of a
 * simplex of all of them no more than 1. */
typedef struct fmb_normal_summand {
    int axes, first; /* directions */
    bool simplex;
} fmb_normal_summand;

/* What is left of all columns at right angles to the directions chosen, and bounds for the numbers
 * of each row and what they are off by. */
typedef struct fmb_normal_rest {
    double x[FMB_NORMALS_MOST_DIM][FMB_NORMAL_COLUMNS], most[FMB_NORMALS_MOST_DIM],
        off[FMB_NORMALS_MOST_DIM];
} fmb_normal_rest;

/* For an overlap / size, as it is in doubles. */
typedef struct fmb_normal_bounds {
    double low, high;
} fmb_normal_bounds;

typedef struct fmb_normal_search {
    fmb_minkowski *m;
    fmb_norm norm;
    fmb_run *run;
    fmb_mem *mem;
    int directions; /* without those of the world, which follow */
    fmb_normal_direction direction[FMB_NORMAL_MOST_DIRECTIONS];
    fmb_normal_summand of[3];
    /* Coordinate j is 2^unit[j] as long as it is here. */
    mp_bitcnt_t unit[FMB_NORMALS_MOST_DIM], coarsest;
    int chosen[FMB_NORMALS_MOST_DIM];
    mpz_t
        *exact; /* [sets] of the first `known` directions chosen: minors by sets of so many rows */
    int known;
    mpz_t *away; /* [dim] origin of P - origin of Q */
    /* In doubles, by the number of directions chosen: columns, whose length is there beside them;
     * that of a coordinate is its share of the longest; all is 2^scale as long as it is there. */
    fmb_normal_rest rest[FMB_NORMALS_MOST_DIM];
    double length[FMB_NORMAL_COLUMNS], share[FMB_NORMALS_MOST_DIM];
    long scale;
    /* The least known; if it waits then it is that of the choice `waiting`, and nobody has seen it
     * in whole numbers. */
    fmb_normal_bounds best;
    bool waits;
    int waiting[FMB_NORMALS_MOST_DIM];
    fmb_least_overlap at; /* the one at hand */
    mpz_t *cell;          /* [cells] all numbers */
    size_t cells;
    mpz_t low, high, span[2], t, s;
} fmb_normal_search;

/* Doubles of all numbers, once the whole ones are there; directions are shortened. */
void fmb_normal_search_scale(fmb_normal_search *x);
/* That is the least overlap now. */
void fmb_normal_search_take(fmb_normal_search *x, const fmb_least_overlap *least);
/* The direction chosen behind so many: do doubles tell that it does not depend on them? They must
 * have told it of those, too. */
bool fmb_normal_is_independent(fmb_normal_search *x, int chosen);
/* If they told it of all: does the normal surely have more overlap than the least? How much? */
bool fmb_normal_is_surely_more(const fmb_normal_search *x);
fmb_normal_bounds fmb_normal_bound(const fmb_normal_search *x);

#endif
