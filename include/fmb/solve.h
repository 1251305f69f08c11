/* fmb/solve.h: the five queries about a system: is it feasible, what is its projection, its
 * tightest box, the best value of a linear form, which rows are redundant.
 *
 * A solver owns the options, the workspace and the last answer; it belongs to one thread at a time
 * and may be used for any number of queries, also after a limit, a cancel or a failed allocation.
 * Besides the errors listed, every query may return RULE, if rules are incompatible, and errors
 * that a rule or chooser of the caller's causes (<fmb/rule.h>). No argument crashes: a solver,
 * system or out that is NULL, or a variable out of range, is ARG, and fmb_solver_trouble says
 * which; the last answer is kept. res may be NULL; else its size must be set (<fmb/base.h>).
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

/* Options, workspace, and the last answer. */
typedef struct fmb_solver fmb_solver;
/* Intervals of variables. */
typedef struct fmb_box fmb_box;
/* The best value of a form, and where it is attained. */
typedef struct fmb_optimum fmb_optimum;

/* The effort of a query. */
typedef struct fmb_stats {
    uint64_t rounds;       /* variables eliminated by pairing rows */
    uint64_t pairs;        /* pairs of rows considered */
    uint64_t rows_made;    /* rows combined */
    uint64_t rows_kept;    /* of those, rows kept by the rules of their round */
    uint64_t rows_dropped; /* pairs and rows dropped by rules */
    uint64_t rows_peak;    /* most live rows at once */
    uint64_t promotions;   /* rows widened to GMP */
    uint64_t pivots;       /* simplex pivots */
    uint64_t lps;          /* linear programs solved exactly */
    size_t bytes_peak;     /* most workspace at once [bytes] */
    double seconds;        /* wall clock [s] */
} fmb_stats;

/* How a query ended. */
typedef struct fmb_result {
    size_t size;         /* sizeof(fmb_result) */
    fmb_verdict verdict; /* of fmb_solve the answer; of all other verbs: is the system feasible */
    fmb_trust trust;     /* how it was obtained */
    fmb_stop stop;       /* FMB_STOP_DONE unless cut short */
    fmb_stats stats;     /* last, as it may grow in later versions */
} fmb_result;

/* [give] Options are copied. Errors: ARG (an option out of range, or instructions that the
 * processor lacks), RULE (a name is unknown, or too many), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solver_new(const fmb_options *o, const fmb_alloc *mem,
                                              fmb_solver **out);
FMB_API void fmb_solver_free(fmb_solver *v);

/* Ask a running query to stop soon; a query that starts later is not affected. The one call allowed
 * from another thread or a signal handler. */
FMB_API void fmb_solver_cancel(fmb_solver *v);

/* Why the last call with this solver returned FMB_ERR_ARG or FMB_ERR_RULE, one line that names the
 * argument, its value or the rules: "keep[2] is 7, but there are 3 variables". After a projection
 * with evidence FMB_EVIDENCE_WHOLE whose completeness is not proved: why not. Else "". Valid until
 * the next call. Errors of a call without a solver are not recorded. */
FMB_API const char *fmb_solver_trouble(const fmb_solver *v);

/* Report events of queries to this sink from now on; {NULL, NULL}: to none. */
FMB_API void fmb_solver_set_sink(fmb_solver *v, fmb_sink sink);

/* Is s satisfiable? Cost can be doubly exponential in dim: set a limit. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solve(fmb_solver *v, const fmb_system *s, fmb_result *res);

/* [give] The projection of s on the variables keep[0..n), strictly increasing: an irredundant
 * system of dimension n with their names; the single row 0 <= -1 if s is infeasible. Its form is
 * canonical: equal projections have the same rows in the same order, however s describes them and
 * whatever the options are. Equations come first, in reduced echelon form: the first variable of
 * each is named by no other row. Then inequalities, those of fewer variables first: one for each
 * facet, < if the facet does not belong to the projection; and for each maximal other face that
 * does not belong to it, one with <, the sum of the facets that contain it. Numbers are coprime
 * integers. If a limit was reached (res->stop), *out is an outer approximation: rows that follow
 * from s, perhaps too few or redundant ones; and claims FEASIBLE in the evidence give an inner one:
 * the kept coordinates of their points are in the projection. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_project(fmb_solver *v, const fmb_system *s, const int *keep,
                                           int n, fmb_system **out, fmb_result *res);

/* [give] The tightest interval of each of the variables vars[0..n), all of them if vars is NULL.
 * *out is NULL if s is infeasible. If a limit was reached, the verdict may be UNKNOWN; ends not yet
 * known are then FMB_END_OUTER, or FMB_END_UNKNOWN where nothing cheap bounds them. Errors: ARG,
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_bound(fmb_solver *v, const fmb_system *s, const int *vars, int n,
                                         fmb_box **out, fmb_result *res);

/* [give] The best value of a linear form over s: the largest or the least, as objective->sense
 * says; objective NULL: of the objective that s carries. *out is NULL if s is infeasible. If a
 * limit was reached, the verdict may be UNKNOWN, and the value may be FMB_END_OUTER or
 * FMB_END_UNKNOWN. Its multipliers are in the evidence, which claims a BOUND or UNBOUNDED of the
 * form without its constant. Errors: ARG (no such sense, a number that is not finite; NULL, and s
 * carries none), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_optimize(fmb_solver *v, const fmb_system *s,
                                            const fmb_objective *objective, fmb_optimum **out,
                                            fmb_result *res);

/* What fmb_reduce found about a row. */
typedef enum fmb_fate {
    FMB_FATE_UNKNOWN = 0, /* a limit was reached first */
    FMB_FATE_KEPT,        /* irredundant */
    FMB_FATE_EQUALITY,    /* an inequality that always holds with equality: kept as an equality */
    FMB_FATE_REDUNDANT    /* follows from the kept rows */
} fmb_fate;

/* [give] An irredundant system with the same solutions: rows of s in their order, inequalities that
 * always hold with equality turned into equalities; the single row 0 <= -1 if s is infeasible.
 * fate[rows], unless NULL, is set for each row of s. If a limit was reached, rows not yet tested
 * are kept; *out is NULL if that limit is max_bytes and a copy of s exceeds it: the result is then
 * s without the rows that are redundant by fate. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_reduce(fmb_solver *v, const fmb_system *s, fmb_fate *fate,
                                          fmb_system **out, fmb_result *res);

/* [give] Evidence for the last query; nothing is copied. If a limit was reached, it has the claims
 * proved so far. Errors: ARG, STATE (no answer, or options.evidence is NONE). */
FMB_API FMB_CHECKED fmb_status fmb_solver_evidence(const fmb_solver *v, fmb_evidence **out);

/* ---- the point, or the rows in conflict -------------------------------------------------------
 *
 * They are read from the evidence of the last answer, if options.evidence was not NONE; else, and
 * if the last query found none or ended with an error, STATE, and fmb_solver_trouble says which.
 */

/* A solution, as the nearest double per coordinate: x[dim] of the queried system. Errors: ARG
 * (NULL), STATE. */
FMB_API FMB_CHECKED fmb_status fmb_solver_point(fmb_solver *v, double *x);
/* Its coordinate j as exact text (fmb_system_term_text); "0" if there is none. */
FMB_API size_t fmb_solver_point_text(const fmb_solver *v, int j, char *text, size_t size);

/* The conflict: *n rows that have no common solution, with multipliers by which they add up to
 * 0 <= negative, or 0 < 0; those of inequalities are positive. It is an irreducible infeasible
 * subsystem (IIS): without any one of its rows the others have a solution; but after a limit
 * (res->stop) it may have more rows. Errors: ARG (NULL), STATE. */
FMB_API FMB_CHECKED fmb_status fmb_solver_conflict(fmb_solver *v, size_t *n);
/* Its k-th row, in increasing order, SIZE_MAX if there is none; the multiplier of that row, an
 * integer, as the nearest double and as exact text; 0 if there is none. */
FMB_API size_t fmb_solver_conflict_row(const fmb_solver *v, size_t k);
FMB_API double fmb_solver_conflict_multiplier(const fmb_solver *v, size_t k);
FMB_API size_t fmb_solver_conflict_multiplier_text(const fmb_solver *v, size_t k, char *text,
                                                   size_t size);

/* ---- boxes ----------------------------------------------------------------------------------- */

/* What is known of an end. */
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

/* If there is no such interval or side: -1, and an end UNKNOWN with value 0. */
FMB_API void fmb_box_free(fmb_box *b);
FMB_API int fmb_box_size(const fmb_box *b);       /* number of intervals */
FMB_API int fmb_box_var(const fmb_box *b, int i); /* the variable of interval i */
FMB_API fmb_end fmb_box_end(const fmb_box *b, int i, fmb_side side);
/* The value of that end rounded to the nearest double, which may lie inside; and as exact text
 * (<fmb/base.h>), "" unless it is finite or outer. */
FMB_API double fmb_box_nearest(const fmb_box *b, int i, fmb_side side);
FMB_API size_t fmb_box_end_text(const fmb_box *b, int i, fmb_side side, char *text, size_t size);
/* The values of all ends at once, rounded outward as fmb_box_end has them: lower[size],
 * upper[size], each of which may be NULL. Errors: ARG (b NULL). */
FMB_API FMB_CHECKED fmb_status fmb_box_ends(const fmb_box *b, double *lower, double *upper);

/* ---- optima ---------------------------------------------------------------------------------- */

/* NULL is fine. */
FMB_API void fmb_optimum_free(fmb_optimum *o);
/* The sense of the objective; NONE for NULL. */
FMB_API fmb_sense fmb_optimum_sense(const fmb_optimum *o);
/* The optimal value, its constant included. FINITE: the optimum, attained or approached; OUTER: no
 * solution has a better value; INFINITE: unbounded. UNKNOWN for NULL. */
FMB_API fmb_end fmb_optimum_end(const fmb_optimum *o);
/* Its value rounded to the nearest double, infinite unless it is finite or outer, 0 for NULL; and
 * as exact text (<fmb/base.h>), "" unless it is finite or outer. */
FMB_API double fmb_optimum_nearest(const fmb_optimum *o);
FMB_API size_t fmb_optimum_value_text(const fmb_optimum *o, char *text, size_t size);
/* Coordinate j, as the nearest double, of a point and, if the form is unbounded, of a ray. The
 * point is at the optimum if that is FINITE: a solution if it is attained, else it satisfies the
 * rows with < read as <=, and solutions come arbitrarily near. Otherwise, if the system is known to
 * be feasible, it is some solution; after a limit, the best one found. From a solution all points
 * along the ray are solutions, and the form increases (for MIN: decreases). 0 if there is none. */
FMB_API double fmb_optimum_coordinate(const fmb_optimum *o, int j);
FMB_API double fmb_optimum_ray(const fmb_optimum *o, int j);
/* These coordinates as exact text. */
FMB_API size_t fmb_optimum_coordinate_text(const fmb_optimum *o, int j, char *text, size_t size);
FMB_API size_t fmb_optimum_ray_text(const fmb_optimum *o, int j, char *text, size_t size);

#ifdef __cplusplus
}
#endif
#endif
