/* fmb/session.h: systems that change. Load one, ask, add or remove rows, ask again.
 *
 *   fmb_solver_load(v, s);
 *   fmb_solve(v, fmb_solver_system(v), &answer);
 *   fmb_solver_push(v);
 *   fmb_solver_add_int(v, cut, FMB_LE, 7);
 *   fmb_solve(v, fmb_solver_system(v), &answer);
 *   fmb_solver_pop(v);
 *
 * The solver keeps a copy of the system, and what fmb_solve, fmb_bound and fmb_optimize have found
 * out about it: the next of them that is asked about it, that is about the very pointer that
 * fmb_solver_system returns, goes on from there (with any method but FM). The answers are those
 * that a fresh solver gives of a copy, with evidence of the rows as they then are; the point of a
 * solution may be another one. Every other query may be asked about it as about any system.
 *
 * Cost: a change costs time in proportion to the row, or (remove) to the number of rows, and linear
 * programs nothing; what is undone before the next question costs it nothing. That question then
 * looks at all rows once, and makes as many steps of the simplex method as it takes from the last
 * basis: often none where rows went or where the last point satisfies the new ones. Rows that are
 * gone stay behind, switched off; when they are most of the rows, and after a limit or a failed
 * allocation has ended a query, the next one begins afresh. All this counts in options.max_bytes.
 *
 * Rows have numbers, which change when others before them go, and handles, which do not: a handle
 * belongs to its row from when the row comes until it goes, comes back with it where
 * fmb_solver_pop brings it back, and is no other row's ever after, also of a system that is loaded
 * later. So rows of a conflict or of evidence are best kept as handles:
 *
 *   fmb_row cut = fmb_solver_last_row(v);                                     (behind an addition)
 *   fmb_solver_remove(v, fmb_solver_row_number(v, cut));
 *   fmb_row guilty = fmb_solver_row(v, fmb_solver_conflict_row(v, k));         (before a change)
 *
 * Errors of all changes: STATE, where nothing is loaded; MEMORY; ARG, which fmb_solver_trouble
 * explains. A change that fails changes nothing. Take evidence (fmb_solver_evidence) before the
 * next change: it speaks of the rows as they were.
 */
#ifndef FMB_SESSION_H
#define FMB_SESSION_H

#include <fmb/solve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Keep a copy of s, in the place of one that was loaded. Errors: ARG (NULL), MEMORY: the older one
 * stays. */
FMB_API FMB_CHECKED fmb_status fmb_solver_load(fmb_solver *v, const fmb_system *s);
/* From now on nothing is loaded; as before where nothing was. */
FMB_API void fmb_solver_unload(fmb_solver *v);
/* The system as it is now, owned by v; the same pointer until another one is loaded. NULL: none. */
FMB_API const fmb_system *fmb_solver_system(const fmb_solver *v);

/* A row of a system that was loaded, now or before. 0: none. */
typedef uint64_t fmb_row;

/* The handle of the row of that number as rows are now; 0 where there is none. And of the last row,
 * that is of the one that was added last, unless it is gone. */
FMB_API fmb_row fmb_solver_row(const fmb_solver *v, size_t number);
FMB_API fmb_row fmb_solver_last_row(const fmb_solver *v);
/* The number of a row; SIZE_MAX while it is not there. Time: logarithmic in the number of rows. */
FMB_API size_t fmb_solver_row_number(const fmb_solver *v, fmb_row row);

/* Append a.x REL b; a has length dim. Errors: ARG as of fmb_system_add. */
FMB_API FMB_CHECKED fmb_status fmb_solver_add(fmb_solver *v, const double *a, fmb_rel rel,
                                              double b);
FMB_API FMB_CHECKED fmb_status fmb_solver_add_int(fmb_solver *v, const int64_t *a, fmb_rel rel,
                                                  int64_t b);
/* Remove a row; the rows behind it move up. Errors: ARG (no such row). */
FMB_API FMB_CHECKED fmb_status fmb_solver_remove(fmb_solver *v, size_t row);
/* Give a row another right side, in the direction in which the row was given: a.x >= b becomes
 * a.x >= the new one, though it is kept, and handed out, as -a.x <= -b. In a text a row is given
 * with its variables moved to the left: 2 <= x is -x <= -2. Errors: ARG (no such row, not finite).
 */
FMB_API FMB_CHECKED fmb_status fmb_solver_set_right(fmb_solver *v, size_t row, double b);

/* The same of numbers that are text, each meant exactly, as in fmb_system_add_terms_text
 * (<fmb/io.h>): append sum coef[k] x_var[k] REL b, and another right side. Errors: PARSE, which
 * fmb_solver_trouble explains, too; ARG as there. */
FMB_API FMB_CHECKED fmb_status fmb_solver_add_terms_text(fmb_solver *v, size_t n, const int *var,
                                                         const char *const *coef, fmb_rel rel,
                                                         const char *b);
FMB_API FMB_CHECKED fmb_status fmb_solver_set_right_text(fmb_solver *v, size_t row, const char *b);

/* Name a row, or not (NULL): fmb_system_label of fmb_solver_system, and messages, tell it. Errors:
 * ARG (no such row). */
FMB_API FMB_CHECKED fmb_status fmb_solver_set_label(fmb_solver *v, size_t row, const char *label);

/* Append a variable, which no row names yet; name NULL: x1, x2, ... by its number. *index, unless
 * index is NULL, is that number. The next question begins afresh. Errors: ARG (as of
 * fmb_system_add_variable). */
FMB_API FMB_CHECKED fmb_status fmb_solver_add_variable(fmb_solver *v, const char *name, int *index);

/* Begin a level; levels nest. */
FMB_API FMB_CHECKED fmb_status fmb_solver_push(fmb_solver *v);
/* End the last level: rows are as they were when it began, in their order, with their labels and
 * handles, and so are variables: those that were added since are gone, with all rows that name
 * them. Errors: STATE (no level), and never MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solver_pop(fmb_solver *v);

#ifdef __cplusplus
}
#endif
#endif
