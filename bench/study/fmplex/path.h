/* path.h: the path from the root of FMplex's search to the node at hand.
 *
 * Node d holds a system equivalent to what the choices of the nodes above leave of the user's: its
 * live rows are rows made there or rows of the nodes above, by reference. So a row lives until its
 * node is left, and memory follows the depth of the path, not the number of nodes tried.
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
    int node;             /* where it was made */
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
    mpq_t cap; /* what was found true here is true for 0 < d <= cap */
    bool capped;
} study_plexnode;

typedef struct study_plexpath {
    fmb_run *run;
    fmb_num num;
    int n;
    size_t length; /* entries of a row */
    fmb_order order;
    study_plexnode *node;          /* [n + 1] */
    int depth;                     /* the node at hand */
    size_t held;                   /* rows made along the path */
    study_plexrow *clash;          /* a false row of the node at hand, or NULL */
    size_t *lower, *upper, *equal; /* [n] live inequalities of either sign; equalities */

    study_plexrow **active; /* [actives] the rows that a conflict combines, */
    mpz_t *weight;          /* with these weights; there is room for n + 3 */
    size_t actives;
    mpz_t alpha, beta, content, part, t;
} study_plexpath;

/* The root: rows of the user. Errors: MEMORY, LIMIT; study_plexpath_clear in any case. */
fmb_status study_plexpath_init(study_plexpath *g, fmb_run *run, fmb_arena *arena, int n, size_t m,
                               const fmb_vec *row, const fmb_rel *rel, const fmb_options *o);
void study_plexpath_clear(study_plexpath *g);

/* Open the node below the one at hand, as its var and via say. Stops at the first false row, which
 * is then g->clash. Errors: MEMORY, LIMIT. */
fmb_status study_plexpath_descend(study_plexpath *g);
/* Leave all nodes below d. */
void study_plexpath_leave(study_plexpath *g, int d);

/* Drop the via of the node at hand, which follows from the other rows. */
void study_plexpath_drop(study_plexpath *g);

/* Choose var and via of the node at hand; false: no row names a variable. */
bool study_plexpath_choose(study_plexpath *g);

/* Trace the clash back. Either the via of some node above follows from the other rows there: it is
 * dropped, that node is at hand with another via, *global is false. Or the rows of the user clash:
 * *global is true, and the multipliers are appended to w (unless NULL). Errors: MEMORY, LIMIT. */
fmb_status study_plexpath_retreat(study_plexpath *g, bool *global, fmb_weights *w);

/* A solution, where no row of the node at hand names a variable. Errors: LIMIT. */
fmb_status study_plexpath_point(const study_plexpath *g, mpq_t *x);

/* ---- for the files of this search ------------------------------------------------------------ */

/* What a constant row s d <= b says holds for d <= b / s only: narrow the node's cap. */
void study_plexpath_cap(const study_plexpath *g, study_plexnode *at, const study_plexrow *r);

#endif
