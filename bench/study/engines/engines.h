/* engines.h: published projection methods that eliminate all variables at once. */
#ifndef FMB_STUDY_ENGINES_H
#define FMB_STUDY_ENGINES_H

#include <fmb/solve.h>

/* [give] The projection of s on the variables keep[0..n), increasing, by the rays of the projection
 * cone: one row for each ray, not made irredundant (block.c). *rays, unless NULL: the number of
 * rays, including those whose row names no variable. Errors: of fmb_generate. */
fmb_status study_block_project(const fmb_system *s, const int *keep, int n, fmb_system **out,
                               size_t *rays);

typedef enum study_balas {
    STUDY_BALAS_PRINTED, /* as in the paper: not always minimal */
    STUDY_BALAS_MENDED   /* Jing and others: an inequality replaces an equation */
} study_balas;

/* [give] The projection, for rows "<=" and an image of full dimension, by Balas' cone, whose
 * extreme rays are the facets (balas.c). *out is NULL where the image is not of full dimension or
 * empty; the printed cone does not always detect an empty one. Errors: ARG (a row that is no "<="),
 * those of fmb_generate and fmb_hull. */
fmb_status study_balas_project(const fmb_system *s, const int *keep, int n, study_balas how,
                               fmb_system **out);

#endif
