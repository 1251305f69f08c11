/* cone.h: double description: from the rows of a cone to its rays and lines.
 *
 * The cone {x in R^d : row.x >= 0 or = 0} is built row by row. In between, it is that of the rows
 * inserted so far: its *lines* are a basis of its lineality space, its *rays* the extreme rays
 * beside that, each once. A row either meets a line, which becomes a ray or, by an equality, goes;
 * or it keeps the rays where it is positive or zero, and makes a new one of each pair of adjacent
 * rays that it separates. The support of a ray is the set of rows in which it is positive, as bits.
 *
 * Rays need not know all their coordinates: what is carried of each is those that are asked for,
 * and its value in every row that is not inserted yet. So no dot product is ever taken, and the row
 * that comes next may be chosen as one goes. Where there are more rows than rays can carry, rows
 * come in the order given, and all coordinates are carried.
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
    bool wanted; /* supports tell of this row even where others imply it */
} fmb_cone_row;

/* Borrowed while the cone is built. */
typedef struct fmb_cone_problem {
    size_t d, m;
    const fmb_cone_row *row; /* [m] */
    size_t keeps;
    const size_t *keep; /* [keeps] the coordinates to carry; NULL: all, and rows come in their
                           order, in which equalities are first */
    bool wide_only;
    bool sparse_first; /* of carried rows those with few coefficients come first */
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
    /* Rows to come. Carried: entry coords + c of a vector is its value in row left[c]. */
    size_t lefts, *left;
    size_t *negatives;        /* [lefts] how many rays are negative there */
    size_t *weight;           /* [m] rows of less weight come first */
    size_t next;              /* not carried: rows before it are inserted */
    uint64_t made;            /* rays made so far; wide ones count more */
    struct fmb_insertion *at; /* the one in progress */
} fmb_cone;

/* Errors: MEMORY, LIMIT. In any case fmb_cone_clear it. */
fmb_status fmb_cone_init(fmb_cone *c, fmb_run *run, const fmb_cone_problem *of);
void fmb_cone_clear(fmb_cone *c);

/* Insert rows until all are, or until that many more rays were made (0: any number), or a slice is
 * over (trace/run.h): *done false, and the next call goes on from there. Errors: MEMORY, LIMIT. */
fmb_status fmb_cone_run(fmb_cone *c, uint64_t rays, bool *done);

/* Is the row of that bit positive in ray i? */
static inline bool fmb_cone_is_positive(const fmb_cone *c, size_t i, size_t bit)
{
    return fmb_set_has(fmb_rays_support(&c->ray, i), bit);
}

#endif
