/* vertex_walk.h: the simplex walk from vertex to vertex in doubles, which yields guesses. */
#ifndef FMB_PAIR_VERTEX_WALK_H
#define FMB_PAIR_VERTEX_WALK_H

#include "pair/exact_box/exact_box_program.h"

enum {
    FMB_WALK_ROWS = FMB_EXACT_BOX_DIM + 2, /* with a sum for each simplex */
    /* Artificial unknowns never enter again; a multiple of four, for vector instructions. */
    FMB_WALK_COLUMNS = (FMB_EXACT_BOX_COLUMNS + 2 + 3) / 4 * 4
};

/* The simplex tableau: z_basic(r) = value_r at the basic solution, and decreases by entry[r][j] for
 * each unit that z_j increases. Columns of unknowns that do not exist are 0. */
typedef struct fmb_exact_box_walk {
    const fmb_exact_box_program *program;
    int rows, columns,
        width; /* columns: 1 + the last existing one; width: rounded up to a multiple of two */
    double entry[FMB_WALK_ROWS][FMB_WALK_COLUMNS], value[FMB_WALK_ROWS];
    int basic[FMB_WALK_ROWS];
    fmb_exact_box_basis basis;
    double weight[FMB_EXACT_BOX_DIM]; /* of artificial unknowns that are not 0: 1 or -1 */
    /* the tableau rows of world coordinates i of A's points, scaled */
    double world[FMB_EXACT_BOX_DIM][FMB_WALK_COLUMNS];
} fmb_exact_box_walk;

/* Walk to a vertex of the common points. False: there seems to be none; the basis then minimizes
 * the sum of the artificial unknowns, with these weights. */
bool fmb_exact_box_walk_start(fmb_exact_box_walk *w, const fmb_exact_box_program *s);
/* Walk from a vertex to one where the goal is optimal. False if that was not reached. */
bool fmb_exact_box_walk_to(fmb_exact_box_walk *w, const fmb_exact_box_goal *goal);

#endif
