/* fmb/session.h: systems that change. Load one, query it, add or remove rows, query it again.
 *
 *   fmb_solver_load(v, s);
 *   fmb_solve(v, fmb_solver_system(v), &answer);
 *   fmb_solver_push(v);
 *   fmb_solver_add_int(v, cut, FMB_LE, 7);
 *   fmb_solve(v, fmb_solver_system(v), &answer);
 *   fmb_solver_pop(v);
 *
 * The solver keeps a copy of the system, and the state of fmb_solve, fmb_bound and fmb_optimize:
 * the next such query about it, that is about the very pointer that fmb_solver_system returns,
 * continues from there (with any method but FM). Answers are those that a fresh solver gives for a
 * copy, with evidence about the current rows; only the point of a solution may be another one. All
 * other queries treat it like any system.
 *
 * Cost: a change takes time proportional to the row, or (remove) to the number of rows, and no
 * linear programs; changes undone before the next query cost it nothing. That query then reads all
 * rows once, and makes as many steps of the simplex method as it needs from the last basis: often
 * none if rows were removed or if the last point satisfies the new ones. Removed rows are kept,
 * switched off; when most rows are such, and after a limit or a failed allocation has ended a
 * query, the next one starts from scratch. All this counts in options.max_bytes.
 *
 * Rows have numbers, which change when earlier rows are removed, and handles, which do not: a
 * handle belongs to its row as long as the row exists, is restored with it by fmb_solver_pop, and
 * is never reused for another row, also not of a system loaded later. So rows of a conflict or of
 * evidence are best kept as handles:
 *
 *   fmb_row cut = fmb_solver_last_row(v);                                     (behind an addition)
 *   fmb_solver_remove(v, fmb_solver_row_number(v, cut));
 *   fmb_row guilty = fmb_solver_row(v, fmb_solver_conflict_row(v, k));         (before a change)
 *
 * Errors of all changes: STATE, if nothing is loaded; MEMORY; ARG, which fmb_solver_trouble
 * explains. A change that fails changes nothing. Take evidence (fmb_solver_evidence) before the
 * next change, as it is about the rows before it.
 */
#ifndef FMB_SESSION_H
#define FMB_SESSION_H

#include <fmb/solve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Load a copy of s, replacing an older one. Errors: ARG (NULL), MEMORY; then the older one is kept.
 */
FMB_API FMB_CHECKED fmb_status fmb_solver_load(fmb_solver *v, const fmb_system *s);
/* Unload the system, if one is loaded. */
FMB_API void fmb_solver_unload(fmb_solver *v);
/* The system as it is now, owned by v; the same pointer until another one is loaded. NULL: none. */
FMB_API const fmb_system *fmb_solver_system(const fmb_solver *v);

/* The handle of a row of a system that is, or was, loaded. 0: none. */
typedef uint64_t fmb_row;

/* The handle of the row that now has this number; 0 if there is none. And of the last row, that is
 * of the one that was added last, unless it was removed. */
FMB_API fmb_row fmb_solver_row(const fmb_solver *v, size_t number);
FMB_API fmb_row fmb_solver_last_row(const fmb_solver *v);
/* The number of a row; SIZE_MAX if it is not there. Time: logarithmic in the number of rows. */
FMB_API size_t fmb_solver_row_number(const fmb_solver *v, fmb_row row);

/* Append a.x REL b; a has length dim. Errors: ARG as of fmb_system_add. */
FMB_API FMB_CHECKED fmb_status fmb_solver_add(fmb_solver *v, const double *a, fmb_rel rel,
                                              double b);
FMB_API FMB_CHECKED fmb_status fmb_solver_add_int(fmb_solver *v, const int64_t *a, fmb_rel rel,
                                                  int64_t b);
/* Remove a row; later rows move up. Errors: ARG (no such row). */
FMB_API FMB_CHECKED fmb_status fmb_solver_remove(fmb_solver *v, size_t row);
/* Set the right side of a row, for the direction in which the row was given: a.x >= b becomes
 * a.x >= the new one, though it is stored, and handed out, as -a.x <= -b. A row from a text counts
 * as given with its variables moved to the left: 2 <= x is -x <= -2. Errors: ARG (no such row, not
 * finite). */
FMB_API FMB_CHECKED fmb_status fmb_solver_set_right(fmb_solver *v, size_t row, double b);

/* Changes with numbers as text, each exact, as in fmb_system_add_terms_text (<fmb/io.h>): append
 * sum coef[k] x_var[k] REL b; set a right side. Errors: PARSE, which fmb_solver_trouble explains,
 * too; ARG as there. */
FMB_API FMB_CHECKED fmb_status fmb_solver_add_terms_text(fmb_solver *v, size_t n, const int *var,
                                                         const char *const *coef, fmb_rel rel,
                                                         const char *b);
FMB_API FMB_CHECKED fmb_status fmb_solver_set_right_text(fmb_solver *v, size_t row, const char *b);

/* Set the label of a row, or remove it (NULL): fmb_system_label of fmb_solver_system returns it,
 * and messages show it. Errors: ARG (no such row). */
FMB_API FMB_CHECKED fmb_status fmb_solver_set_label(fmb_solver *v, size_t row, const char *label);

/* Append a variable, which no row names yet; name NULL: x1, x2, ... by its number. *index, unless
 * index is NULL, is that number. The next query starts from scratch. Errors: ARG (as of
 * fmb_system_add_variable). */
FMB_API FMB_CHECKED fmb_status fmb_solver_add_variable(fmb_solver *v, const char *name, int *index);

/* Begin a level; levels nest. */
FMB_API FMB_CHECKED fmb_status fmb_solver_push(fmb_solver *v);
/* End the last level: rows are again as they were when it began, in their order, with their labels
 * and handles, and so are variables: those added since are removed, with all rows that name them.
 * Errors: STATE (no level), and never MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solver_pop(fmb_solver *v);

#ifdef __cplusplus
}
#endif
#endif
