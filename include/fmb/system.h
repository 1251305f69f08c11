/* fmb/system.h: a system of linear inequalities, as the user wrote it.
 *
 * A system is a list of rows a.x REL b over dim real variables, REL in {<=, <, =}. Rows and
 * variables count from 0 here (from 1 in files and reports). Coefficients are exact rationals: a
 * double means its exact binary value, so 0.1 is not 1/10 (use text or <fmb/gmp.h> for that).
 * Rows are stored sparse; the order of rows is kept.
 */
#ifndef FMB_SYSTEM_H
#define FMB_SYSTEM_H

#include <fmb/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fmb_system fmb_system;

/* [give] An empty system over dim >= 0 variables named x1, x2, ... Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_new(int dim, const fmb_alloc *mem, fmb_system **out);
/* [give] A deep copy with the same allocator. Errors: MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_copy(const fmb_system *s, fmb_system **out);
FMB_API void fmb_system_free(fmb_system *s);

/* Number of variables; number of rows. */
FMB_API int fmb_system_dim(const fmb_system *s);
FMB_API size_t fmb_system_rows(const fmb_system *s);

/* Append a.x REL b; a has length dim. Errors: ARG (non-finite, bad relation), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add(fmb_system *s, const double *a, fmb_rel rel,
                                              double b);
FMB_API FMB_CHECKED fmb_status fmb_system_add_int(fmb_system *s, const int64_t *a, fmb_rel rel,
                                                  int64_t b);
/* Relation of row i < rows. */
FMB_API fmb_rel fmb_system_rel(const fmb_system *s, size_t i);

/* Append the rows of another system, with their labels; its variable j is variable var[j] of s,
 * which may come twice. var NULL: the same numbers. So systems are stacked: the solutions of s are
 * then common ones. Nothing is appended on failure. Errors: ARG (variable out of range), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_join(fmb_system *s, const fmb_system *more,
                                               const int *var);

/* Append a variable (its coefficient is 0 in all rows so far); *index (may be NULL) gets its place.
 * name NULL means the default name. Errors: ARG (empty name, or name taken), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_variable(fmb_system *s, const char *name, int *index);
/* Name of variable j < dim: never NULL, owned by s, valid until the next change of s. */
FMB_API const char *fmb_system_name(const fmb_system *s, int j);
/* Rename variable j. Errors: ARG (empty, or taken by another variable), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_set_name(fmb_system *s, int j, const char *name);
/* Index of the variable of that name, or -1. */
FMB_API int fmb_system_find(const fmb_system *s, const char *name);

/* Label of row i: NULL if it has none; owned by s. Setting NULL removes it. Errors: MEMORY. */
FMB_API const char *fmb_system_label(const fmb_system *s, size_t i);
FMB_API FMB_CHECKED fmb_status fmb_system_set_label(fmb_system *s, size_t i, const char *label);

/* The variables that the source asks to project on (`project` and `eliminate` lines of .ine files):
 * a mark per variable, all false if the source asks for nothing. Errors: MEMORY. */
FMB_API bool fmb_system_asks_projection(const fmb_system *s);
FMB_API bool fmb_system_is_kept(const fmb_system *s, int j);
FMB_API void fmb_system_set_kept(fmb_system *s, int j, bool kept);

#ifdef __cplusplus
}
#endif
#endif
