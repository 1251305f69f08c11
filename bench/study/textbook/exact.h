/* exact.h: the ground truth. Textbook Fourier-Motzkin elimination on GMP rationals: no pruning
 * beyond rows with the left side of a tighter row (always sound without histories), no cleverness,
 * nothing shared with elim, lp or solve.
 *
 * Meant for small systems: cost is doubly exponential in dim. max_rows > 0 bounds the rows alive;
 * beyond it the answer is FMB_UNKNOWN (*out untouched).
 */
#ifndef FMB_STUDY_TEXTBOOK_EXACT_H
#define FMB_STUDY_TEXTBOOK_EXACT_H

#include <fmb/gmp.h>

/* Is s satisfiable? Errors: MEMORY. */
FMB_CHECKED fmb_status study_textbook_solve(const fmb_system *s, size_t max_rows, fmb_verdict *out);

/* One end of an interval: kind as in fmb_end, value (initialised by the caller) set if finite. */
typedef struct study_textbook_end {
    fmb_end_kind kind;
    bool attained;
    mpq_t value;
} study_textbook_end;

/* Tightest interval of variable var: end[FMB_LOWER], end[FMB_UPPER]. *out is the verdict on s; the
 * ends are set only if it is FMB_FEASIBLE. Errors: MEMORY, ARG. */
FMB_CHECKED fmb_status study_textbook_bound(const fmb_system *s, int var, size_t max_rows,
                                            study_textbook_end end[2], fmb_verdict *out);

/* [give] The projection on keep[0..n), increasing: not irredundant, names kept. Errors: MEMORY,
 * ARG. */
FMB_CHECKED fmb_status study_textbook_project(const fmb_system *s, const int *keep, int n,
                                              size_t max_rows, fmb_system **out,
                                              fmb_verdict *verdict);

#endif
