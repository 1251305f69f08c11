/* support.h: a projection as the hull of what support queries find (convex hull method).
 *
 * An inner hull of points and rays of the projection is kept, facet by facet
 * (hull/facets/facets.h). How far does the projection go in the direction of a facet? If no further
 * than the facet, it stands: the multipliers of the optimum prove its row. Else the optimum is a
 * point more, or the way to infinity a ray. Each query finds a facet or a generator, and there are
 * only so many vertices and rays of a program. At any time there are inner points and proved rows.
 *
 * The same for hulls that are flat: an equation of all generators stands if the projection goes no
 * further on either side. Of rows that are strict the closure counts; at the end is asked which
 * facets and other faces the projection lacks (support_strict.c).
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

/* A row of the projection: a.x <= b, < b or = b over its k variables. */
typedef struct fmb_support_row {
    fmb_integers z; /* [k + 1] a, then b: coprime */
    fmb_rel rel;
    fmb_weights proof, reverse; /* over the oracle's rows; reverse: of an equality, a.x >= b */
} fmb_support_row;

/* The point x / den, or den = 0 and a direction x in which the projection goes on for ever. */
typedef struct fmb_support_point {
    fmb_integers x; /* [n] */
    mpz_t den;
} fmb_support_point;

/* The facets that a generator made or touched; some of them may be gone. */
typedef struct fmb_support_near {
    size_t generator;
    uint32_t *slot; /* [slots] */
    size_t slots, capacity;
} fmb_support_near;

/* Who looks how far the projection goes. */
typedef struct fmb_support_worker {
    fmb_run *run;
    fmb_oracle *oracle;
    fmb_support_point seen; /* last */
    fmb_support_near near;  /* the generator found last, in the query's own memory */
    mpz_t t;                /* scratch */
} fmb_support_worker;

typedef struct fmb_symmetry fmb_symmetry; /* of the program (support_symmetry.c) */
typedef struct fmb_known fmb_known;       /* rows of the program (support_known.c) */

typedef struct fmb_support {
    fmb_run *run;
    fmb_support_worker worker;
    fmb_symmetry *symmetry; /* of the program, or NULL */
    size_t n, k;            /* columns; those that are kept, */
    const int *kept;        /* [k], increasing */
    bool strict;            /* some row of the program is strict */
    bool proves;            /* proofs are wanted */
    size_t most;            /* generators, with more of which asking ends; 0: any number */
    fmb_facets hull;        /* of (1, x) and (0, x) */
    fmb_known *known;       /* or NULL */
    bool begun, ended;      /* ended: by an error, so that nothing more may be asked */
    size_t equations;       /* these of the hull stand */
    size_t at;              /* the facet to begin with when looking for one that does not stand */
    fmb_support_row *row;   /* [rows] proved */
    size_t rows, row_capacity;
    size_t outer_after, outer_most; /* rows are wanted that are no facets: from when, how many */
    size_t ends_asked;              /* of the coordinates, on either side */
    fmb_support_row *outer;         /* [outers] proved */
    size_t outers, outer_capacity;
    fmb_integers g;      /* scratch: [k + 1] a point or ray of the projection */
    fmb_integers *point; /* [points] of proofs: x[0..n) over x[n], or with x[n] = 0 a direction, of
                            the closure; their shadows are generators of the hull */
    size_t points, point_capacity;
} fmb_support;

/* The oracle's program, of n columns, is known to have a solution. kept[k] must outlive this. In
 * any case fmb_support_clear it. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_support_init(fmb_support *s, fmb_run *run, fmb_oracle *oracle, size_t n,
                            const int *kept, size_t k, bool strict, bool proves);
void fmb_support_clear(fmb_support *s);

/* These are symmetries of the program that keep the kept columns; before anything is asked. The
 * group goes over to here, whatever the status. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_use_symmetry(fmb_support *s, fmb_group *group);

/* All columns are kept, and no proofs are wanted: a facet that is a row of p, the program, stands
 * without a query, and is not told. p has no strict rows. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_know_rows(fmb_support *s, const fmb_program *p);

/* Before facets, ask how far the projection goes along its coordinates. From so many rows and
 * generators on, ask the same of facets of the hull that do not stand, until there are so many rows
 * that hold whatever comes. */
static inline void fmb_support_want_outer_rows(fmb_support *s, size_t after, size_t most)
{
    s->outer_after = after;
    s->outer_most = most;
}
/* They become rows like others: at a limit. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_keep_outer_rows(fmb_support *s);

/* Images of rows whose facets the hull has not come to yet become rows, too: at a limit. Errors:
 * MEMORY, LIMIT: the rows that there are hold. */
fmb_status fmb_support_keep_images(fmb_support *s);

/* Ask about facets and equations until all stand: *done; or until a slice is over (trace/run.h); or
 * until the hull has looked at so many pairs of facets for ridges, 0: any number. (Queries are
 * about as many as the projection has facets and vertices; it is inner hulls that may have many
 * more.) What is proved stays so, whatever ends the call; but after an error it is the last one. */
fmb_status fmb_support_ask(fmb_support *s, uint64_t pairs, bool *done);

#endif
