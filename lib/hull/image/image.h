/* image.h: what a cone looks like in some of its coordinates, by rays, and the rows that say so.
 *
 * A cone over (x, t) with t >= 0 stands for the polyhedron of its points at t = 1; rays with t = 0
 * are directions. Leaving out coordinates of its rays and lines projects it; the rows of the
 * projection are the rays of the dual cone, those that are always equalities its lines.
 *
 * Each point of the projection keeps the support of the rays above it, so that of each facet the
 * rows are known that are tight on all of its preimage: the facet is a combination of those, it is
 * strict if one of them is, and no others are needed to prove it.
 */
#ifndef FMB_HULL_IMAGE_H
#define FMB_HULL_IMAGE_H

#include "dd/cone.h"
#include "hull/facets/facets.h"

/* A row of the image: v[0..n-1).x <= v[n-1], or = , or <. */
typedef struct fmb_image_row {
    fmb_vec v;
    bool equality, strict;
    uint64_t *slack; /* rows of the cone, by bit, that are positive somewhere above the facet */
    uint64_t *on;    /* rays of the image on it, as they were sorted; both NULL: not asked for */
} fmb_image_row;

typedef struct fmb_image {
    fmb_run *run;
    fmb_num num;
    const fmb_cone *of; /* or NULL */
    fmb_arena arena;
    size_t n, words; /* coordinates, t last; words of a support */
    fmb_vec *ray;    /* [rays], each once, sorted; not 0 */
    uint64_t **support;
    const fmb_vec **above; /* [rays] one of the cone's, with all that it carries, or NULL */
    uint32_t *residue;     /* [rays + 1][n] of rays and a row; NULL: not asked for yet */
    size_t rays;
    fmb_vec *line; /* [lines], not 0 */
    const fmb_vec **line_above;
    size_t lines;
    uint64_t *everywhere; /* union of the supports of rays that are 0 in the image */
    bool has_point;       /* some ray has t > 0 */
    fmb_image_row *facet;
    size_t facets, facet_capacity;
} fmb_image;

/* The cone is complete, and outlives the image. Of the coordinates that it carries the first n
 * count, the last of these is t. Errors: MEMORY, LIMIT. In any case fmb_image_clear it. */
fmb_status fmb_image_init(fmb_image *m, fmb_run *run, const fmb_cone *of, size_t n, bool wide_only);
/* The same of vectors v[vectors], n entries each, rays or lines. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_init_vectors(fmb_image *m, fmb_run *run, size_t n, size_t vectors,
                                  const fmb_vec *v, const bool *line, bool wide_only);
void fmb_image_clear(fmb_image *m);

/* The dual of the cone spanned by the rays and lines of `of`, by way of its facets (facets.h):
 * these are the rays, its equations are the lines. For few coordinates. Errors: MEMORY, LIMIT. In
 * any case clear it. */
fmb_status fmb_image_init_dual(fmb_image *m, const fmb_image *of);

/* y.(x, t) >= 0, or = 0, is a row of the image; with `slacks` it is told what is on and above it.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_image_add_facet(fmb_image *m, const fmb_vec *y, bool equality, bool slacks);
/* Of the rays leave those that are corners by rows that know what is on them; rays on all of these
 * become lines. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_keep_corners(fmb_image *m);

/* Find the facets of an image that has a point. With `slacks` each facet gets its slack. Errors:
 * MEMORY, LIMIT. */
fmb_status fmb_image_find_facets(fmb_image *m, bool slacks);
/* Is that done ray by ray, which needs no other way? Else it is done by rows of the dual cone. */
bool fmb_image_has_few_coordinates(const fmb_image *m);

/* The facets in the making, ray by ray. In any case fmb_image_hull_close it. Errors: MEMORY, LIMIT,
 * here and below. */
typedef struct fmb_image_hull {
    fmb_image *of;
    fmb_facets facets;
    fmb_facet_crowd *crowd;
} fmb_image_hull;

fmb_status fmb_image_hull_open(fmb_image_hull *h, fmb_image *m);
void fmb_image_hull_close(fmb_image_hull *h);
/* Go on until the image has its facets: *done; or a slice is over. */
fmb_status fmb_image_hull_find_facets(fmb_image_hull *h, bool slacks, bool *done);

/* The dual cone in the making. */
typedef struct fmb_dual {
    fmb_image *of;
    size_t rows;
    fmb_cone_row *row; /* [rows] lines of the image as equalities, then its rays, in their order */
    size_t *all;       /* [n] coordinates */
    fmb_cone cone;
} fmb_dual;

/* Its rows come in lexicographic order, or those of few coefficients first. In any case
 * fmb_dual_close it. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_dual_open(fmb_dual *d, fmb_image *m, bool sparse_first);
void fmb_dual_close(fmb_dual *d);
/* Go on until the image has its facets: *done; or until so many more rays were made, 0: any number.
 */
fmb_status fmb_dual_find_facets(fmb_dual *d, uint64_t rays, bool slacks, bool *done);
/* Facets are told by the rays and lines of the dual cone. No slacks. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_take_facets(fmb_image *m, const fmb_image *dual);

/* Where rows of the cone are strict, by bit (excludes[words]), faces of the image are not in the
 * projection: those above which a strict row is tight everywhere. Facets become strict; a lower
 * face gets a row of its own, the sum of facets that meet in it. *empty: no point is left. *done
 * false: there are too many faces to look at. Facets have been found, with slacks. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_image_open_faces(fmb_image *m, const uint64_t *excludes, bool *empty, bool *done);

/* Put the rays where row is 0 into a set that is empty. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_find_zeros(fmb_image *m, const fmb_vec *row, uint64_t *zero);
/* Sign of row.ray, n entries each. */
int fmb_image_value_sign(fmb_image *m, const fmb_vec *row, const fmb_vec *ray);

/* ---- for the other files of this room -------------------------------------------------------- */

/* *to, new, becomes the first coordinates of a ray or line, in lowest terms. Errors: MEMORY, LIMIT.
 * In any case clear it. */
fmb_status fmb_image_copy_coordinates(fmb_image *m, fmb_vec *to, const fmb_vec *from);

#endif
