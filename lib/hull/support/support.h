/* support.h: a projection as the hull of the answers of support queries (convex hull method).
 *
 * An inner hull of points and rays of the projection is kept, facet by facet
 * (hull/facets/facets.h). A query maximizes in the direction of a facet. If the optimum is on it,
 * the facet stands: the multipliers of the optimum prove its row. Otherwise the hull gets a new
 * point, or a ray if there is no optimum. Each query finds a facet or a generator, and a program
 * has finitely many vertices and rays. At any time there are inner points and proved rows.
 *
 * Flat hulls are treated alike: an equation of all generators stands if the projection exceeds it
 * on neither side. Strict rows are replaced by their closures; at the end further queries show
 * which facets and other faces the projection lacks (support_strict.c).
 *
 * Sources: Lassez 1990, Querying constraints; Huynh, Lassez, Lassez 1992; Jones, Kerrigan,
 * Maciejowski 2004, Equality set projection.
 */
#ifndef FMB_HULL_SUPPORT_H
#define FMB_HULL_SUPPORT_H

#include "hull/facets/facets.h"
#include "lp/oracle/oracle.h"
#include "num/integers.h"
#include "symmetry/group.h"
#include "trace/run.h"

/* A row of the projection: a.x <= b, < b or = b over the k kept variables. */
typedef struct fmb_support_row {
    fmb_integers z; /* [k + 1] a, then b: coprime */
    fmb_rel rel;
    fmb_weights proof, reverse; /* over the oracle's rows; reverse: of a.x >= b, if equality */
} fmb_support_row;

/* The point x / den; or, if den = 0, a direction x of the recession cone. */
typedef struct fmb_support_point {
    fmb_integers x; /* [n] */
    mpz_t den;
} fmb_support_point;

/* The facets that a generator made or touched; some of them may have been removed since. */
typedef struct fmb_support_near {
    size_t generator;
    uint32_t *slot; /* [slots] */
    size_t slots, capacity;
} fmb_support_near;

typedef struct fmb_symmetry fmb_symmetry; /* of the program (support_symmetry.c) */
typedef struct fmb_known fmb_known;       /* rows of the program (support_known.c) */

typedef struct fmb_support {
    fmb_run *run;
    fmb_oracle *oracle;
    fmb_support_point seen; /* the last answer */
    fmb_support_near near;  /* the generator found last */
    mpz_t t;                /* scratch */
    fmb_symmetry *symmetry; /* of the program, or NULL */
    size_t n, k;            /* columns; kept columns, */
    const int *kept;        /* [k], increasing */
    bool strict;            /* some row of the program is strict */
    bool proves;            /* are proofs wanted? */
    size_t most;            /* queries end with more generators than this; 0: never */
    fmb_facets hull;        /* of (1, x) and (0, x) */
    fmb_known *known;       /* or NULL */
    bool begun, ended;      /* ended: by an error, after which no query is allowed */
    size_t equations;       /* so many equations of the hull stand */
    size_t at;              /* where the search for an open facet begins */
    fmb_support_row *row;   /* [rows] proved */
    size_t rows, row_capacity;
    size_t outer_after, outer_most; /* wanted rows that are no facets: from when, how many */
    size_t ends_asked;              /* queries for bounds of coordinates so far */
    fmb_support_row *outer;         /* [outers] proved */
    size_t outers, outer_capacity;
    fmb_integers g;      /* scratch: [k + 1] a point or ray of the projection */
    fmb_integers *point; /* [points] of proofs: x[0..n) over x[n], or with x[n] = 0 a direction, of
                            the closure; their projections are generators of the hull */
    size_t points, point_capacity;
} fmb_support;

/* The oracle's program, of n columns, has a solution. kept[k] must outlive s. The caller must call
 * fmb_support_clear even after an error. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_support_init(fmb_support *s, fmb_run *run, fmb_oracle *oracle, size_t n,
                            const int *kept, size_t k, bool strict, bool proves);
void fmb_support_clear(fmb_support *s);

/* Use symmetries of the program that keep the kept columns; to be called before any query. s takes
 * the group over, whatever the status. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_use_symmetry(fmb_support *s, fmb_group *group);

/* For queries without proofs that keep all columns: a facet that is a row of the program p stands
 * without a query, and gets no row. p has no strict rows. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_know_rows(fmb_support *s, const fmb_program *p);

/* Before facets, query the bounds of the coordinates. Once rows and generators are `after` or more,
 * also query facets of the hull that do not stand, until there are `most` proved rows that are no
 * facets, and hold however the hull grows. */
static inline void fmb_support_want_outer_rows(fmb_support *s, size_t after, size_t most)
{
    s->outer_after = after;
    s->outer_most = most;
}
/* At a limit: keep these rows like others. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_keep_outer_rows(fmb_support *s);

/* At a limit: keep the images of rows that are not yet facets of the hull as rows, too. Errors:
 * MEMORY, LIMIT; the rows present are valid even then. */
fmb_status fmb_support_keep_images(fmb_support *s);

/* Query facets and equations until all stand, *done; or a slice is over (trace/run.h); or the hull
 * has tested so many pairs of facets for ridges (0: any number). (Queries are about as many as
 * facets and vertices of the projection; inner hulls may have many more.) Proved rows stay proved,
 * whatever ends the call; but after an error no further call is allowed. */
fmb_status fmb_support_ask(fmb_support *s, uint64_t pairs, bool *done);

#endif
