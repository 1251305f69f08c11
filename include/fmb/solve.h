/* fmb/solve.h: the four questions. Is it feasible, what is its projection, its tightest box, which
 * rows are redundant.
 *
 * A solver owns the options, the workspace and the last answer; it belongs to one thread at a time
 * and may be used for any number of queries, also after a limit, a cancel or a failed allocation.
 * Besides the errors listed, every query may return RULE, where rules do not go together, and what
 * a rule or chooser of the caller's brings about (<fmb/rule.h>).
 */
#ifndef FMB_SOLVE_H
#define FMB_SOLVE_H

#include <fmb/options.h>
#include <fmb/proof.h>
#include <fmb/system.h>
#include <fmb/trace.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fmb_solver fmb_solver;
typedef struct fmb_box fmb_box;

typedef struct fmb_stats {
    uint64_t rounds;       /* variables eliminated by pairing rows */
    uint64_t pairs;        /* pairs of rows looked at */
    uint64_t rows_made;    /* rows combined */
    uint64_t rows_kept;    /* of those, rows still there after the rules of their round */
    uint64_t rows_dropped; /* pairs and rows dropped by rules */
    uint64_t rows_peak;    /* most live rows at once */
    uint64_t promotions;   /* rows widened to GMP */
    uint64_t pivots;       /* simplex pivots */
    uint64_t lps;          /* linear programs solved exactly */
    size_t bytes_peak;     /* most workspace at once [bytes] */
    double seconds;        /* wall clock [s] */
} fmb_stats;

typedef struct fmb_result {
    fmb_verdict verdict; /* the answer; of project, bound and reduce: is the system feasible */
    fmb_trust trust;     /* how it was obtained */
    fmb_stop stop;       /* FMB_STOP_DONE unless cut short */
    fmb_stats stats;
} fmb_result;

/* [give] Options are copied. Errors: ARG (an option out of range, or instructions that the
 * processor lacks), RULE (a name is unknown, or too many), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solver_new(const fmb_options *o, const fmb_alloc *mem,
                                              fmb_solver **out);
FMB_API void fmb_solver_free(fmb_solver *v);

/* Ask a running query to stop soon; a query that starts later is not touched. The one call allowed
 * from another thread or a signal handler. */
FMB_API void fmb_solver_cancel(fmb_solver *v);

/* Watch queries from now on; {NULL, NULL} is silence. */
FMB_API void fmb_solver_set_sink(fmb_solver *v, fmb_sink sink);

/* Is s satisfiable? Cost can be doubly exponential in dim: set a limit. Errors: MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solve(fmb_solver *v, const fmb_system *s, fmb_result *res);

/* [give] The projection of s on the variables keep[0..n), strictly increasing: an irredundant
 * system of dimension n with their names; the single row 0 <= -1 if s is infeasible. If a limit was
 * reached (res->stop), *out is an outer one: rows that follow from s, perhaps too few or more than
 * are needed. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_project(fmb_solver *v, const fmb_system *s, const int *keep,
                                           int n, fmb_system **out, fmb_result *res);

/* [give] The tightest interval of each of the variables vars[0..n), all of them if vars is NULL.
 * *out is NULL if s is infeasible. If a limit was reached, the verdict may be UNKNOWN; ends not yet
 * known are then FMB_END_OUTER, or FMB_END_UNKNOWN where nothing cheap bounds them. Errors: ARG,
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_bound(fmb_solver *v, const fmb_system *s, const int *vars, int n,
                                         fmb_box **out, fmb_result *res);

/* What became of a row. */
typedef enum fmb_fate {
    FMB_FATE_UNKNOWN = 0, /* a limit was reached first */
    FMB_FATE_KEPT,        /* irredundant */
    FMB_FATE_EQUALITY,    /* an inequality that always holds with equality: kept as an equality */
    FMB_FATE_REDUNDANT    /* follows from the rows that stay */
} fmb_fate;

/* [give] An irredundant system with the same solutions: rows of s in their order, inequalities that
 * always hold with equality turned into equalities; the single row 0 <= -1 if s is infeasible.
 * fate[rows], unless NULL, says what became of each. If a limit was reached, rows not yet tested
 * are kept. Errors: MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_reduce(fmb_solver *v, const fmb_system *s, fmb_fate *fate,
                                          fmb_system **out, fmb_result *res);

/* [give] Evidence for the last query. Errors: STATE (no answer, or options.evidence off), MEMORY.
 */
FMB_API FMB_CHECKED fmb_status fmb_solver_evidence(const fmb_solver *v, fmb_evidence **out);

/* ---- boxes ----------------------------------------------------------------------------------- */

typedef enum fmb_end_kind {
    FMB_END_UNKNOWN = 0,
    FMB_END_FINITE,
    FMB_END_INFINITE,
    FMB_END_OUTER /* no solution is beyond the end, but it may be too far out: a limit was reached
                   */
} fmb_end_kind;

/* One end of an interval. */
typedef struct fmb_end {
    fmb_end_kind kind;
    bool attained; /* some solution is known to reach the end; false unless finite */
    double value;  /* rounded outward; -INFINITY or INFINITY unless finite or outer */
} fmb_end;

FMB_API void fmb_box_free(fmb_box *b);
FMB_API int fmb_box_size(const fmb_box *b);       /* number of intervals */
FMB_API int fmb_box_var(const fmb_box *b, int i); /* the variable of interval i */
FMB_API fmb_end fmb_box_end(const fmb_box *b, int i, fmb_side side);

#ifdef __cplusplus
}
#endif
#endif
