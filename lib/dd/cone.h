/* cone.h: the double description method: from the rows of a cone to its rays and lines.
 *
 * The cone {x in R^d : row.x >= 0 or = 0} is built row by row. Each intermediate cone is that of
 * the rows inserted so far: its *lines* are a basis of its lineality space, its *rays* the extreme
 * rays modulo that, each once. A row that is not zero on some line turns one line into a ray, or
 * removes it if the row is an equality; another row keeps the rays where it is positive or zero,
 * and makes a new ray of each pair of adjacent rays that it separates. The support of a ray is the
 * set of rows in which it is positive, as bits.
 *
 * Rays need not carry all coordinates, only those asked for and the value in each row not inserted
 * yet. So no dot product is ever computed, and the next row may be chosen dynamically. If there are
 * more rows than rays can carry, rows are inserted in the given order and all coordinates carried.
 *
 * Sources: Motzkin, Raiffa, Thompson and Thrall 1953, The double description method; Fukuda and
 * Prodon 1996, Double description method revisited.
 */
#ifndef FMB_DD_CONE_H
#define FMB_DD_CONE_H

#include "dd/rays.h"
#include "num/bitset.h"
#include "trace/run.h"

/* row.x >= 0, or = 0. */
typedef struct fmb_cone_row {
    const fmb_vec *v; /* [d] */
    bool equality;
    bool wanted; /* supports have this row even if others imply it */
} fmb_cone_row;

/* The caller's data, borrowed while the cone is built. */
typedef struct fmb_cone_problem {
    size_t d, m;
    const fmb_cone_row *row; /* [m] */
    size_t keeps;
    const size_t *keep; /* [keeps] the coordinates to carry; NULL: all, and rows are inserted in
                           their order, equalities first */
    bool wide_only;
    bool sparse_first; /* of carried rows, insert those with few coefficients first */
} fmb_cone_problem;

typedef struct fmb_cone {
    fmb_run *run;
    fmb_num num;
    fmb_cone_problem of;
    size_t coords; /* entries of a vector that are coordinates; the others are values in rows */
    fmb_rays line; /* without supports */
    fmb_rays ray;
    size_t rank;        /* of the inequalities inserted, on the space of the equalities */
    size_t bits;        /* of supports in use */
    size_t *row_of_bit; /* [m] */
    /* Rows not inserted yet. Carried: entry coords + c of a vector is its value in row left[c]. */
    size_t lefts, *left;
    size_t *negatives;        /* [lefts] number of rays negative in that row */
    size_t *weight;           /* [m] rows of less weight come first */
    size_t next;              /* not carried: the next row to insert */
    uint64_t made;            /* rays made so far; wide ones count more */
    struct fmb_insertion *at; /* the insertion in progress */
} fmb_cone;

/* Errors: MEMORY, LIMIT. The caller must call fmb_cone_clear even after an error. */
fmb_status fmb_cone_init(fmb_cone *c, fmb_run *run, const fmb_cone_problem *of);
void fmb_cone_clear(fmb_cone *c);

/* Insert rows until none is left; or pause, *done false, after so many more rays (0: any number) or
 * at the end of a slice (trace/run.h); the next call continues. Errors: MEMORY, LIMIT. */
fmb_status fmb_cone_run(fmb_cone *c, uint64_t rays, bool *done);

/* Is the row of that bit positive in ray i? */
static inline bool fmb_cone_is_positive(const fmb_cone *c, size_t i, size_t bit)
{
    return fmb_set_has(fmb_rays_support(&c->ray, i), bit);
}

#endif
