/* tree_walk.h: a simultaneous descent of two trees, or of one with itself, to pairs of cells; or a
 * test of all pairs without trees. */
#ifndef FMB_MESH_TREE_WALK_H
#define FMB_MESH_TREE_WALK_H

#include <stdatomic.h>

#include "mesh/cells_as_frames.h"
#include "trace/run.h"

/* The data that all threads share. */
typedef struct fmb_walk_plan {
    const fmb_mesh *a, *b;         /* the same one for self-intersections */
    const uint32_t *ids_a, *ids_b; /* equal numbers for equal points, across both */
    const fmb_mesh_options *o;
    fmb_mesh_clearance clearance; /* pairs within it are hits, too */
    fmb_mesh_nearest *nearest;    /* wanted, or NULL; if wanted, the clearance is found first */
    size_t from, to;              /* without trees: rows of pairs, cells of a; else from == to */
    fmb_run run;                  /* its clock; each walk has a copy */
    atomic_int stopped;           /* by the caller, or because a thread failed */
    bool cancelled;               /* stopped by the caller */
    _Atomic uint64_t done;        /* share of the pairs of cells, roughly [1 / FMB_WALK_UNITS] */
} fmb_walk_plan;

#define FMB_WALK_UNITS 0x1p50

/* The walk of one thread over some pairs of nodes. */
typedef struct fmb_tree_walk {
    fmb_walk_plan *plan;
    fmb_mem mem; /* of the hits */
    fmb_run run; /* stops with the plan, or at the deadline */
    fmb_mesh_frames frames;
    fmb_mesh_answer out; /* without its size */
    bool tells;          /* this thread reports progress */
    unsigned unheard;    /* leaves done but not yet added to plan->done */
    double weight;       /* the sum of their weights */
    fmb_status st;
} fmb_tree_walk;

/* A pair of nodes, p of a and q of b; p == q: all pairs within the node. */
typedef struct fmb_walk_part {
    const fmb_mesh_node *p, *q;
    double weight; /* share of all pairs of cells, roughly */
} fmb_walk_part;

enum { FMB_WALK_MOST_PARTS = 256 };

/* Divide all pairs into parts, at most FMB_WALK_MOST_PARTS; returns their number. */
int fmb_walk_parts(const fmb_walk_plan *plan, fmb_walk_part out[FMB_WALK_MOST_PARTS]);

/* Append the hits of a part to x->out. Errors: MEMORY, LIMIT (of x->mem; or stopped). */
fmb_status fmb_walk_part_of_trees(fmb_tree_walk *x, const fmb_walk_part *part);
/* Append the hits of cell `row` of a with all cells of b (a == b: later ones), without boxes. */
fmb_status fmb_walk_row_of_pairs(fmb_tree_walk *x, uint32_t row);

#endif
