/* image.h: the projection of a cone onto some of its coordinates: its rays and its rows.
 *
 * A cone over (x, t) with t >= 0 stands for the polyhedron of its points at t = 1; rays with t = 0
 * are directions. Dropping coordinates of its rays and lines projects it; the rows of the
 * projection are the rays of the dual cone, and its equalities are the lines of the dual cone.
 *
 * Each ray of the image keeps the supports of the rays above it, so that the rows that are tight on
 * the whole preimage of a facet are known: the facet is a combination of these rows, it is strict
 * if one of them is, and no other rows are needed to prove it.
 */
#ifndef FMB_HULL_IMAGE_H
#define FMB_HULL_IMAGE_H

#include "dd/cone.h"
#include "hull/facets/facets.h"

/* A row of the image: v[0..n-1).x <= v[n-1], or = , or <. */
typedef struct fmb_image_row {
    fmb_vec v;
    bool equality, strict;
    uint64_t *slack; /* set of rows of the cone that are positive somewhere above the facet */
    uint64_t *on;    /* set of rays of the image on it, by index; both NULL: not wanted */
} fmb_image_row;

typedef struct fmb_image {
    fmb_run *run;
    fmb_num num;
    const fmb_cone *of; /* or NULL */
    fmb_arena arena;
    size_t n, words; /* coordinates, t last; words of a support */
    fmb_vec *ray;    /* [rays], each once, sorted; not 0 */
    uint64_t **support;
    const fmb_vec **above; /* [rays] a ray of the cone with all its coordinates, or NULL */
    uint32_t *residue;     /* [rays + 1][n] of rays and a row; NULL: not computed yet */
    size_t rays;
    fmb_vec *line; /* [lines], not 0 */
    const fmb_vec **line_above;
    size_t lines;
    uint64_t *everywhere; /* union of the supports of rays that are 0 in the image */
    bool has_point;       /* some ray has t > 0 */
    fmb_image_row *facet;
    size_t facets, facet_capacity;
} fmb_image;

/* The cone is complete, and outlives the image. The image has the first n coordinates that the cone
 * carries; the last of these is t. Errors: MEMORY, LIMIT; call fmb_image_clear even then. */
fmb_status fmb_image_init(fmb_image *m, fmb_run *run, const fmb_cone *of, size_t n, bool wide_only);
/* The same for the vectors v[vectors] of n entries, rays or lines. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_init_vectors(fmb_image *m, fmb_run *run, size_t n, size_t vectors,
                                  const fmb_vec *v, const bool *line, bool wide_only);
void fmb_image_clear(fmb_image *m);

/* The dual of the cone spanned by the rays and lines of `of`, computed by its facets (facets.h):
 * the facets become rays, the equations lines. For few coordinates. Errors: MEMORY, LIMIT. The
 * caller must call fmb_image_clear even then. */
fmb_status fmb_image_init_dual(fmb_image *m, const fmb_image *of);

/* Add y.(x, t) >= 0, or = 0, to the rows of the image; with `slacks` compute its `on` and `slack`.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_image_add_facet(fmb_image *m, const fmb_vec *y, bool equality, bool slacks);
/* Remove the rays that are not extreme, judged by the rows whose `on` is known; rays on all of
 * these rows become lines. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_keep_corners(fmb_image *m);

/* Find the facets of an image that has a point. With `slacks` each facet gets its `on` and `slack`.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_image_find_facets(fmb_image *m, bool slacks);
/* Are facets found ray by ray, so that no other way is needed? Else by the dual cone. */
bool fmb_image_has_few_coordinates(const fmb_image *m);

/* Facets computed ray by ray, in steps. The caller must call fmb_image_hull_close even after an
 * error. Errors: MEMORY, LIMIT, here and below. */
typedef struct fmb_image_hull {
    fmb_image *of;
    fmb_facets facets;
    fmb_facet_crowd *crowd;
} fmb_image_hull;

fmb_status fmb_image_hull_open(fmb_image_hull *h, fmb_image *m);
void fmb_image_hull_close(fmb_image_hull *h);
/* Continue until the image has its facets, *done, or a slice is over. */
fmb_status fmb_image_hull_find_facets(fmb_image_hull *h, bool slacks, bool *done);

/* The dual cone, computed in steps. */
typedef struct fmb_dual {
    fmb_image *of;
    size_t rows;
    fmb_cone_row *row; /* [rows] lines of the image as equalities, then its rays, in their order */
    size_t *all;       /* [n] coordinates */
    fmb_cone cone;
} fmb_dual;

/* Its rows come in lexicographic order, or sorted by their number of coefficients. The caller must
 * call fmb_dual_close even after an error. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_dual_open(fmb_dual *d, fmb_image *m, bool sparse_first);
void fmb_dual_close(fmb_dual *d);
/* Continue until the image has its facets, *done, or so many more rays were made (0: any number).
 */
fmb_status fmb_dual_find_facets(fmb_dual *d, uint64_t rays, bool slacks, bool *done);
/* Add the rays and lines of the dual cone as facets, without slacks. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_take_facets(fmb_image *m, const fmb_image *dual);

/* If rows of the cone, the set excludes[words], are strict, the projection lacks some faces of the
 * image: those above which a strict row is tight everywhere. Facets of this kind become strict; a
 * lower face gets a row, the sum of facets that meet in it. *empty: no point is left. *done false:
 * there are too many faces. The facets must have been found, with slacks. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_open_faces(fmb_image *m, const uint64_t *excludes, bool *empty, bool *done);

/* Add the rays on which row is 0 to an empty set. Errors: MEMORY, LIMIT. */
fmb_status fmb_image_find_zeros(fmb_image *m, const fmb_vec *row, uint64_t *zero);
/* Sign of row.ray, n entries each. */
int fmb_image_value_sign(fmb_image *m, const fmb_vec *row, const fmb_vec *ray);

/* ---- for the other files of this room -------------------------------------------------------- */

/* *to, new, becomes the first n entries of a ray or line, in lowest terms. Errors: MEMORY, LIMIT.
 * The caller must clear it even then. */
fmb_status fmb_image_copy_coordinates(fmb_image *m, fmb_vec *to, const fmb_vec *from);

#endif
