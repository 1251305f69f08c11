/* engines.h: projections by others' ways that are no pruning rules: all variables at once. */
#ifndef FMB_STUDY_ENGINES_H
#define FMB_STUDY_ENGINES_H

#include <fmb/solve.h>

/* [give] The projection of s on the variables keep[0..n), increasing, by the rays of the projection
 * cone: a row for each, none looked at twice (block.c). *rays, unless NULL: how many there were,
 * rows that name no variable among them. Errors: of fmb_generate. */
fmb_status study_block_project(const fmb_system *s, const int *keep, int n, fmb_system **out,
                               size_t *rays);

typedef enum study_balas {
    STUDY_BALAS_PRINTED, /* as the paper has it: not always minimal */
    STUDY_BALAS_MENDED   /* with the inequality that Jing and others put in place of an equation */
} study_balas;

/* [give] The same, of rows "<=" and an image of full dimension, by Balas' cone, whose extreme rays
 * are the facets (balas.c). *out is NULL where it is not of full dimension, and if it is
 * empty, which the printed cone does not always tell. Errors: ARG (a
 * row that is no "<="), of fmb_generate and fmb_hull. */
fmb_status study_balas_project(const fmb_system *s, const int *keep, int n, study_balas how,
                               fmb_system **out);

#endif
