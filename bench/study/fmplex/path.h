/* path.h: the path from the root of FMplex's search to the current node.
 *
 * Node d holds a system equivalent to the user's under the choices of the nodes above: its live
 * rows are rows made there or, by reference, rows of the nodes above. So a row lives until its node
 * is left, and memory grows with the depth of the path, not with the number of nodes tried.
 *
 * A row is a primitive integer vector: n coefficients, the right side, and the coefficient of an
 * infinitesimal d > 0: a.x + s d <= b. A strict row a.x < b starts with s = 1 (Dutertre and de
 * Moura 2006), so that no row is strict and one argument serves all.
 */
#ifndef FMB_STUDY_FMPLEX_PATH_H
#define FMB_STUDY_FMPLEX_PATH_H

#include "study/fmplex/fmplex.h"

typedef struct study_plexrow study_plexrow;
struct study_plexrow {
    fmb_vec v;
    study_plexrow *p, *q; /* made by cancelling the parent's variable; NULL for a row of the user */
    int node;             /* the node that made it */
    uint32_t slot;        /* 1 + its place in the conflict under study, 0: not in it */
    bool equality;
};

typedef struct study_plexnode {
    study_plexrow *
        *live; /* [lives] the system of this node, [lives..filled) rows dropped from it */
    size_t lives, filled, live_capacity;
    study_plexrow *made; /* [mades] rows made here */
    size_t mades, made_capacity;
    int64_t *words; /* [word_capacity] their entries */
    size_t word_capacity;
    int var; /* being eliminated below this node */
    study_plexrow
        *via;  /* the bound tried, or the equality; NULL: var has bounds of one sign only */
    mpq_t cap; /* what was found here holds for 0 < d <= cap */
    bool capped;
} study_plexnode;

typedef struct study_plexpath {
    fmb_run *run;
    fmb_num num;
    int n;
    size_t length; /* entries of a row */
    fmb_order order;
    study_plexnode *node;          /* [n + 1] */
    int depth;                     /* the current node */
    size_t held;                   /* rows made along the path */
    study_plexrow *clash;          /* a false row of the current node, or NULL */
    size_t *lower, *upper, *equal; /* [n] live inequalities of either sign; equalities */

    study_plexrow **active; /* [actives] the rows that a conflict combines, */
    mpz_t *weight;          /* with these weights; there is room for n + 3 */
    size_t actives;
    mpz_t alpha, beta, content, part, t;
} study_plexpath;

/* The root: rows of the user. Errors: MEMORY, LIMIT. Even then call study_plexpath_clear. */
fmb_status study_plexpath_init(study_plexpath *g, fmb_run *run, fmb_arena *arena, int n, size_t m,
                               const fmb_vec *row, const fmb_rel *rel, const fmb_options *o);
void study_plexpath_clear(study_plexpath *g);

/* Open the child of the current node that its var and via define. Stops at the first false row,
 * which is then g->clash. Errors: MEMORY, LIMIT. */
fmb_status study_plexpath_descend(study_plexpath *g);
/* Leave all nodes below d. */
void study_plexpath_leave(study_plexpath *g, int d);

/* Drop the via of the current node, which follows from the other rows. */
void study_plexpath_drop(study_plexpath *g);

/* Choose var and via of the current node; false: no row names a variable. */
bool study_plexpath_choose(study_plexpath *g);

/* Trace the clash back. Either the via of some node above follows from the other rows there: it is
 * dropped, that node becomes current with another via, *global is false. Or the user's rows clash:
 * *global is true, and their multipliers are appended to w (unless NULL). Errors: MEMORY, LIMIT. */
fmb_status study_plexpath_retreat(study_plexpath *g, bool *global, fmb_weights *w);

/* A solution, if no row of the current node names a variable. Errors: LIMIT. */
fmb_status study_plexpath_point(const study_plexpath *g, mpq_t *x);

/* ---- for the files of this search ------------------------------------------------------------ */

/* Whether a constant row s d <= b holds may change at d = b / s: lower the node's cap to that. */
void study_plexpath_cap(const study_plexpath *g, study_plexnode *at, const study_plexrow *r);

#endif
