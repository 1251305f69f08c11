/* features.h: what a part looks like once what is cheap has been eliminated: by that the ways of a
 * projection are chosen (selection.h).
 */
#ifndef FMB_SOLVE_FEATURES_H
#define FMB_SOLVE_FEATURES_H

#include "solve/portfolio/reduced_part.h"

/* Variables and rows that are left, coefficients, and rows with one of those. */
size_t fmb_features_columns(const fmb_reduced_part *h);
size_t fmb_features_rows(const fmb_reduced_part *h);
size_t fmb_features_entries(const fmb_reduced_part *h);
size_t fmb_features_bounds(const fmb_reduced_part *h);
/* Some numbers are longer than a word, or so long in all rows that those of combinations will be.
 */
bool fmb_features_is_long(const fmb_reduced_part *h);
/* [bits] About as long is a minor of all columns, if rows are like the mean of them. */
size_t fmb_features_minor_bits(const fmb_reduced_part *h);
/* All variables at 0 are a solution of what is left. */
bool fmb_features_has_origin(const fmb_reduced_part *h);
/* The least of dimensions and of rows beyond as many, of the cone: up to 10 or so it has few rays.
 */
size_t fmb_features_freedom(const fmb_reduced_part *h);

#endif
