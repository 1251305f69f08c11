/* tree_walk.h: two trees side by side, or one with itself, down to pairs of cells; or all of these.
 */
#ifndef FMB_MESH_TREE_WALK_H
#define FMB_MESH_TREE_WALK_H

#include <stdatomic.h>

#include "mesh/cells_as_frames.h"
#include "trace/run.h"

/* What all threads share. */
typedef struct fmb_walk_plan {
    const fmb_mesh *a, *b;         /* the same one for self-intersections */
    const uint32_t *ids_a, *ids_b; /* equal numbers for equal points, across both */
    const fmb_mesh_options *o;
    fmb_mesh_clearance clearance; /* apart by no more than that, they are hits, too */
    fmb_mesh_nearest *nearest;    /* asked for, or NULL: then the clearance is ours to find */
    size_t from, to;              /* without trees: rows of pairs, cells of a; else from == to */
    fmb_run run;                  /* its clock; each walk has a copy */
    atomic_int stopped;           /* by the caller, or since a thread failed */
    bool cancelled;               /* the former */
    _Atomic uint64_t done;        /* of the pairs of cells, roughly [1 / FMB_WALK_UNITS] */
} fmb_walk_plan;

#define FMB_WALK_UNITS 0x1p50

/* One thread's way through some pairs of nodes. */
typedef struct fmb_tree_walk {
    fmb_walk_plan *plan;
    fmb_mem mem; /* of the hits */
    fmb_run run; /* stopped with the plan, or since time is up */
    fmb_mesh_frames frames;
    fmb_mesh_answer out; /* without its size */
    bool tells;          /* this thread tells progress */
    unsigned unheard;    /* leaves since what is done was shared; */
    double weight;       /* theirs */
    fmb_status st;
} fmb_tree_walk;

/* A pair of nodes, q that of b; p == q: all pairs within it. */
typedef struct fmb_walk_part {
    const fmb_mesh_node *p, *q;
    double weight; /* of all pairs of cells, roughly */
} fmb_walk_part;

enum { FMB_WALK_MOST_PARTS = 256 };

/* All pairs, in at most so many parts; their number. */
int fmb_walk_parts(const fmb_walk_plan *plan, fmb_walk_part out[FMB_WALK_MOST_PARTS]);

/* Append hits to x->out. Errors: MEMORY, LIMIT (of x->mem; or stopped). */
fmb_status fmb_walk_part_of_trees(fmb_tree_walk *x, const fmb_walk_part *part);
/* The same of cell `row` of a and each of b, or of a behind it, whatever their boxes. */
fmb_status fmb_walk_row_of_pairs(fmb_tree_walk *x, uint32_t row);

#endif
