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

/* A system. */
typedef struct fmb_system fmb_system;

/* The most variables of a system: names and marks take some 70 bytes each, used or not. */
#define FMB_DIM_MAX 1000000

/* [give] An empty system over 0 <= dim <= FMB_DIM_MAX variables named x1, x2, ... Errors: ARG,
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_new(int dim, const fmb_alloc *mem, fmb_system **out);
/* [give] A deep copy with the same allocator. Errors: ARG (NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_copy(const fmb_system *s, fmb_system **out);
FMB_API void fmb_system_free(fmb_system *s);

/* What was wrong with the arguments of the last call on s that returned FMB_ERR_ARG, or with the
 * numbers of fmb_system_add_terms_text, in one line: which one, and its value or name; "" if no
 * call failed. Valid until the next change of s. */
FMB_API const char *fmb_system_trouble(const fmb_system *s);

/* Number of variables; number of rows. */
FMB_API int fmb_system_dim(const fmb_system *s);
FMB_API size_t fmb_system_rows(const fmb_system *s);

/* Append a.x REL b; a has length dim. Errors: ARG (NULL, non-finite, bad relation), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add(fmb_system *s, const double *a, fmb_rel rel,
                                              double b);
FMB_API FMB_CHECKED fmb_status fmb_system_add_int(fmb_system *s, const int64_t *a, fmb_rel rel,
                                                  int64_t b);
/* Append sum coef[k] x_var[k] REL b, n terms in any order; terms of the same variable are added up.
 * Errors: ARG (as above; variable out of range), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_terms(fmb_system *s, size_t n, const int *var,
                                                    const double *coef, fmb_rel rel, double b);
FMB_API FMB_CHECKED fmb_status fmb_system_add_terms_int(fmb_system *s, size_t n, const int *var,
                                                        const int64_t *coef, fmb_rel rel,
                                                        int64_t b);
/* Append many rows, all or, on failure, none. Row i has the terms start[i] <= k < start[i + 1] (a
 * matrix in compressed rows, CSR; start has rows + 1 entries), as above; with start and var NULL,
 * the coefficients coef[i * dim .. (i + 1) * dim). Its relation is rel[i], <= if rel is NULL; its
 * right side b[i]. Errors: ARG (also: a row that ends before it begins; fmb_system_trouble names
 * the row and the variable or term), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_rows(fmb_system *s, size_t rows, const size_t *start,
                                                   const int *var, const double *coef,
                                                   const fmb_rel *rel, const double *b);
FMB_API FMB_CHECKED fmb_status fmb_system_add_rows_int(fmb_system *s, size_t rows,
                                                       const size_t *start, const int *var,
                                                       const int64_t *coef, const fmb_rel *rel,
                                                       const int64_t *b);

/* Relation of row i < rows; FMB_LE if there is no such row. */
FMB_API fmb_rel fmb_system_rel(const fmb_system *s, size_t i);
/* Number of nonzero terms of row i, 0 if there is no such row; and of all rows. */
FMB_API size_t fmb_system_terms(const fmb_system *s, size_t i);
FMB_API size_t fmb_system_nonzeros(const fmb_system *s);
/* The rows first .. first + n in compressed rows: start[n + 1], from 0; var and coef by term, of
 * which there are start[n] (fmb_system_terms of one row, fmb_system_nonzeros of all), by increasing
 * variable; rel[n]; b[n]. Each of these may be NULL. As doubles: the nearest. As integers: RANGE,
 * and nothing is written, if a requested number is no integer of 64 bits. Errors: ARG (no such
 * rows), RANGE. */
FMB_API FMB_CHECKED fmb_status fmb_system_get_rows(const fmb_system *s, size_t first, size_t n,
                                                   size_t *start, int *var, double *coef,
                                                   fmb_rel *rel, double *b);
FMB_API FMB_CHECKED fmb_status fmb_system_get_rows_int(const fmb_system *s, size_t first, size_t n,
                                                       size_t *start, int *var, int64_t *coef,
                                                       fmb_rel *rel, int64_t *b);
/* All rows as one object, so that the caller need not allocate. The arrays belong to it. */
typedef struct fmb_matrix {
    size_t rows, terms; /* terms: of all rows */
    int dim;
    const size_t *start; /* [rows + 1] */
    const int *var;      /* [terms] */
    const double *coef;  /* [terms] the nearest doubles */
    const fmb_rel *rel;  /* [rows] */
    const double *b;     /* [rows] */
} fmb_matrix;

/* [give, fmb_matrix_free] The rows of s as they are now, with its allocator. Errors: ARG, MEMORY.
 */
FMB_API FMB_CHECKED fmb_status fmb_system_matrix(const fmb_system *s, fmb_matrix **out);
FMB_API void fmb_matrix_free(fmb_matrix *m);
/* The coefficient of term k of row i as exact text, "-1/3", and its right side; "0" if there is
 * none. Returns the length without the NUL, and writes text[size] only if size is larger, like all
 * functions for numbers as text (<fmb/base.h>). */
FMB_API size_t fmb_system_term_text(const fmb_system *s, size_t i, size_t k, char *text,
                                    size_t size);
FMB_API size_t fmb_system_rhs_text(const fmb_system *s, size_t i, char *text, size_t size);

/* Append the rows of another system, with their labels; its variable j is variable var[j] of s,
 * which may occur repeatedly, and is integer if either is. var NULL: the same numbers. So systems
 * are combined: the solutions of s are then the common ones. Nothing is appended on failure.
 * Errors: ARG (variable out of range), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_join(fmb_system *s, const fmb_system *more,
                                               const int *var);

/* Append a variable (its coefficient is 0 in all rows so far); *index (may be NULL) gets its place.
 * name NULL means the default name. Errors: ARG (empty name, name taken, or FMB_DIM_MAX variables
 * already), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_variable(fmb_system *s, const char *name, int *index);
/* Name of variable j, owned by s, valid until the next change of s; NULL unless 0 <= j < dim. */
FMB_API const char *fmb_system_name(const fmb_system *s, int j);
/* Rename variable j. Errors: ARG (empty, or taken by another variable), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_set_name(fmb_system *s, int j, const char *name);
/* Index of the variable of that name, or -1. */
FMB_API int fmb_system_find(const fmb_system *s, const char *name);

/* Label of row i: NULL if it has none; owned by s. Setting NULL removes it. Errors: ARG, MEMORY. */
FMB_API const char *fmb_system_label(const fmb_system *s, size_t i);
FMB_API FMB_CHECKED fmb_status fmb_system_set_label(fmb_system *s, size_t i, const char *label);

/* The variables on which the source requests a projection (`project` and `eliminate` lines of .ine
 * files): a mark per variable, all false if it requests none. */
FMB_API bool fmb_system_asks_projection(const fmb_system *s);
FMB_API bool fmb_system_is_kept(const fmb_system *s, int j);
FMB_API void fmb_system_set_kept(fmb_system *s, int j, bool kept);

/* The variables that the source says are integer (`Int` of SMT-LIB, integer columns of MPS and LP,
 * `integer` lines of .fmb): a mark per variable, false unless it was set, which copies and joins
 * keep. It is a note to the caller, as libfmb answers over the reals: infeasible, a bound and a
 * redundant row hold for integers too, but "feasible" says so only if the witness is integral on
 * the marked variables. Errors: ARG (no such variable); is_integer of no variable is false. */
FMB_API FMB_CHECKED fmb_status fmb_system_set_integer(fmb_system *s, int j, bool integer);
FMB_API bool fmb_system_is_integer(const fmb_system *s, int j);

/* Whether a linear form is maximized or minimized. */
typedef enum fmb_sense { FMB_SENSE_NONE = 0, FMB_SENSE_MAX, FMB_SENSE_MIN } fmb_sense;

/* A linear form coef.x + constant to be maximized or minimized; in rationals: fmb_objective_q of
 * <fmb/gmp.h>. */
typedef struct fmb_objective {
    fmb_sense sense;
    const double *coef; /* [dim]; a double means its exact binary value */
    double constant;
} fmb_objective;

/* A system may carry one objective, which only fmb_optimize uses: `max` and `min` lines of .fmb,
 * `maximize` and `minimize` of .ine and SMT-LIB, the objectives of MPS and LP. The objective is
 * copied and replaces an older one; NULL, or one without sense, removes it. Copies of a system keep
 * it, and the results of fmb_reduce; so does a projection that keeps all variables in the
 * objective. A join does not change that of s. Errors: ARG (coef NULL, a number that is not finite,
 * no such sense), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_set_objective(fmb_system *s, const fmb_objective *o);
/* Set an objective of n terms, as in fmb_system_add_terms; it needs a sense. Errors: ARG (also:
 * variable out of range), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_set_objective_terms(fmb_system *s, fmb_sense sense,
                                                              size_t n, const int *var,
                                                              const double *coef, double constant);
FMB_API FMB_CHECKED fmb_status fmb_system_set_objective_terms_int(fmb_system *s, fmb_sense sense,
                                                                  size_t n, const int *var,
                                                                  const int64_t *coef,
                                                                  int64_t constant);
/* Sense of the objective; NONE: there is none. And the number of its nonzero terms. */
FMB_API fmb_sense fmb_system_sense(const fmb_system *s);
FMB_API size_t fmb_system_objective_terms(const fmb_system *s);
/* Its sense; its terms by increasing variable, as the nearest doubles, and its constant; all but s
 * may be NULL. Nothing is written if there is none. */
FMB_API fmb_sense fmb_system_get_objective(const fmb_system *s, int *var, double *coef,
                                           double *constant);
/* Its numbers as integers: RANGE, and nothing is written, if a requested number is no integer of 64
 * bits. OK, and nothing is written, if there is no objective. Errors: ARG (s NULL), RANGE. */
FMB_API FMB_CHECKED fmb_status fmb_system_get_objective_int(const fmb_system *s, int *var,
                                                            int64_t *coef, int64_t *constant);
/* Its numbers as text, like fmb_system_term_text. */
FMB_API size_t fmb_system_objective_term_text(const fmb_system *s, size_t k, char *text,
                                              size_t size);
FMB_API size_t fmb_system_objective_constant_text(const fmb_system *s, char *text, size_t size);

#ifdef __cplusplus
}
#endif
#endif
