/* fmb/symmetry.h: symmetries of a system, given or found, and the rows of a projection by classes.
 *
 * A symmetry of a system, of which some variables are kept, is a permutation of its variables that
 * takes each row to a row (up to a positive factor), and kept variables to such. It takes the
 * projection to itself. So do all that are made of some, and the rows of the projection fall into
 * classes, those that these take to one another.
 *
 * Source: Gläßle, Gross and Chaves 2018, Computational tools for solving a marginal problem with
 * applications in Bell non-locality and causal modeling, Journal of Physics A 51.
 */
#ifndef FMB_SYMMETRY_H
#define FMB_SYMMETRY_H

#include <fmb/io.h>
#include <fmb/solve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A list of permutations of dim variables. */
typedef struct fmb_permutations fmb_permutations;

/* [give] None yet. Errors: ARG (dim < 0, out NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_permutations_new(int dim, const fmb_alloc *mem,
                                                    fmb_permutations **out);
FMB_API void fmb_permutations_free(fmb_permutations *p);
/* Append the one that takes variable j to image[j]. Errors: ARG (it takes two to one, or out of
 * range), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_permutations_add(fmb_permutations *p, const int *image);
/* What was wrong with the arguments of the last addition, in one line: "variables 0 and 2 both go
 * to 1"; "" if nothing was, and for NULL. Good until the next addition. */
FMB_API const char *fmb_permutations_trouble(const fmb_permutations *p);
FMB_API int fmb_permutations_dim(const fmb_permutations *p);
FMB_API size_t fmb_permutations_size(const fmb_permutations *p);
/* Where the i-th takes variable j; -1 where there is none. */
FMB_API int fmb_permutations_image(const fmb_permutations *p, size_t i, int j);

/* From now on fmb_project uses these, unless options.symmetry is NONE; NULL: none again. They are
 * copied. They are checked in
 * each query: one that is no symmetry of its system and kept set is FMB_ERR_ARG, and
 * fmb_solver_trouble says which and why. Errors: ARG (v is NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solver_set_symmetries(fmb_solver *v, const fmb_permutations *p);

/* [give] Symmetries of s, keep[0..n) being kept, that all others are made of; none where the system
 * is large or has long numbers, or nauty is not installed. *out is NULL at a limit.
 * Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_symmetries_find(fmb_solver *v, const fmb_system *s,
                                                   const int *keep, int n, fmb_permutations **out,
                                                   fmb_result *res);

/* Classes of the rows of a projection on keep[0..n) under symmetries of what was projected:
 * class[i] is the first row of the class of row i. Rows whose images are missing, as at a limit,
 * are in smaller classes. Errors: ARG (NULL; a projection not over n variables; keep out of range,
 * or permutations that take a kept variable elsewhere), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_rows_classes(const fmb_system *projection,
                                                const fmb_permutations *p, const int *keep, int n,
                                                size_t *class_of);

/* [give] Symmetries of s, keep[0..n) being kept, from text (docs/formats.md, "symmetries"): lines
 * such as "x y z <> y z x". Errors: PARSE (malformed, no such variable, no symmetry: *where is
 * filled, if not NULL), IO, MEMORY, ARG. */
FMB_API FMB_CHECKED fmb_status fmb_permutations_read(FILE *in, const fmb_reader *how,
                                                     const fmb_system *s, const int *keep, int n,
                                                     fmb_permutations **out, fmb_where *where);
FMB_API FMB_CHECKED fmb_status fmb_permutations_parse(const char *text, size_t size,
                                                      const fmb_reader *how, const fmb_system *s,
                                                      const int *keep, int n,
                                                      fmb_permutations **out, fmb_where *where);

#ifdef __cplusplus
}
#endif
#endif
