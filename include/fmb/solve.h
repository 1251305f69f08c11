/* fmb/solve.h: the five questions. Is it feasible, what is its projection, its tightest box, the
 * best value of a linear form, which rows are redundant.
 *
 * A solver owns the options, the workspace and the last answer; it belongs to one thread at a time
 * and may be used for any number of queries, also after a limit, a cancel or a failed allocation.
 * Besides the errors listed, every query may return RULE, where rules do not go together, and what
 * a rule or chooser of the caller's brings about (<fmb/rule.h>). No argument crashes: a solver,
 * system or out that is NULL, or a variable out of range, is ARG, and fmb_solver_trouble says
 * which; the last answer stays. res may be NULL; else its size
 * is set (<fmb/base.h>).
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
/* The best value of a form, and where it is reached. */
typedef struct fmb_optimum fmb_optimum;

/* What a query took. */
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

/* How a query ended. */
typedef struct fmb_result {
    size_t size;         /* sizeof(fmb_result) */
    fmb_verdict verdict; /* the answer; of all other verbs: is the system feasible */
    fmb_trust trust;     /* how it was obtained */
    fmb_stop stop;       /* FMB_STOP_DONE unless cut short */
    fmb_stats stats;     /* last, as it is what grows */
} fmb_result;

/* [give] Options are copied. Errors: ARG (an option out of range, or instructions that the
 * processor lacks), RULE (a name is unknown, or too many), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solver_new(const fmb_options *o, const fmb_alloc *mem,
                                              fmb_solver **out);
FMB_API void fmb_solver_free(fmb_solver *v);

/* Ask a running query to stop soon; a query that starts later is not touched. The one call allowed
 * from another thread or a signal handler. */
FMB_API void fmb_solver_cancel(fmb_solver *v);

/* Why the last call with this solver returned FMB_ERR_ARG or FMB_ERR_RULE, one line that names the
 * argument, its value or the rules: "keep[2] is 7, but there are 3 variables". After a projection
 * with evidence FMB_EVIDENCE_WHOLE whose completeness is not proved: why not. Else "".
 * Good until the next call. A call without a solver has nowhere to say it. */
FMB_API const char *fmb_solver_trouble(const fmb_solver *v);

/* Watch queries from now on; {NULL, NULL} is silence. */
FMB_API void fmb_solver_set_sink(fmb_solver *v, fmb_sink sink);

/* Is s satisfiable? Cost can be doubly exponential in dim: set a limit. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solve(fmb_solver *v, const fmb_system *s, fmb_result *res);

/* [give] The projection of s on the variables keep[0..n), strictly increasing: an irredundant
 * system of dimension n with their names; the single row 0 <= -1 if s is infeasible. Its form is
 * canonical: equal projections have the same rows in the same order, however s describes them and
 * whatever the options are. Equations come first, in reduced echelon form: the first variable of
 * each is named by no other row. Then inequalities, those of fewer variables first: one for each
 * facet, < where the facet is missing; and where other faces are missing, one with < for each of
 * the largest, the sum of the facets that hold it. Numbers are coprime integers. If a limit was
 * reached (res->stop), *out is an outer one: rows that follow from s, perhaps too few or more than
 * are needed; and evidence of what was found from within has claims FEASIBLE: the kept coordinates
 * of their points are in the projection. Errors: ARG, MEMORY. */
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
 * are kept; *out is NULL where that limit is max_bytes and a copy of s is more than it: s is what
 * is known then, without the rows that fate says to be redundant. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_reduce(fmb_solver *v, const fmb_system *s, fmb_fate *fate,
                                          fmb_system **out, fmb_result *res);

/* [give] Evidence for the last query; nothing is copied. Where a limit was reached, what was proved
 * so far. Errors: ARG, STATE (no answer, or options.evidence is NONE). */
FMB_API FMB_CHECKED fmb_status fmb_solver_evidence(const fmb_solver *v, fmb_evidence **out);

/* ---- the point, or the rows in conflict -------------------------------------------------------
 *
 * What the last answer rests on, if options.evidence was not NONE; else, and where the last query
 * found no such thing or ended with an error, STATE, and fmb_solver_trouble says which.
 */

/* A solution, as the nearest double per coordinate: x[dim] of the system that was asked about.
 * Errors: ARG (NULL), STATE. */
FMB_API FMB_CHECKED fmb_status fmb_solver_point(fmb_solver *v, double *x);
/* Its coordinate j as exact text (fmb_system_term_text); "0" where there is none. */
FMB_API size_t fmb_solver_point_text(const fmb_solver *v, int j, char *text, size_t size);

/* The conflict: rows that have no common solution, each with the multiplier by which they add up to
 * 0 <= negative, or 0 < 0; those of inequalities are positive. It is an irreducible infeasible
 * subsystem (IIS): without any of its rows the others have a solution; unless res->stop told of a
 * limit, when it may have more rows than that. *n rows. Errors: ARG (NULL), STATE. */
FMB_API FMB_CHECKED fmb_status fmb_solver_conflict(fmb_solver *v, size_t *n);
/* Its k-th row, in increasing order, SIZE_MAX where there is none; the multiplier of that row, a
 * whole number, as the nearest double and as exact text; 0 where there is none. */
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

/* Where there is no such interval or side: -1, and an end UNKNOWN with value 0. */
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
/* Which way the form was to go; NONE for NULL. */
FMB_API fmb_sense fmb_optimum_sense(const fmb_optimum *o);
/* How far it goes, its constant included. FINITE: the optimum, attained or approached; OUTER: no
 * solution is beyond; INFINITE: unbounded. UNKNOWN for NULL. */
FMB_API fmb_end fmb_optimum_end(const fmb_optimum *o);
/* Its value rounded to the nearest double, infinite unless it is finite or outer, 0 for NULL; and
 * as exact text (<fmb/base.h>), "" unless it is finite or outer. */
FMB_API double fmb_optimum_nearest(const fmb_optimum *o);
FMB_API size_t fmb_optimum_value_text(const fmb_optimum *o, char *text, size_t size);
/* Coordinate j, as the nearest double, of a point and, if the form is unbounded, of a ray. The
 * point is at the optimum where that is FINITE: a solution if it is attained, else it satisfies the
 * rows with < read as <=, and solutions come as near as you like. In other cases, where the system
 * is known to be feasible, it is some solution; after a limit, the best that was met. From a
 * solution every point along the ray is one, and the form grows (for MIN: falls). 0 where there is
 * none. */
FMB_API double fmb_optimum_coordinate(const fmb_optimum *o, int j);
FMB_API double fmb_optimum_ray(const fmb_optimum *o, int j);
/* The same as exact text. */
FMB_API size_t fmb_optimum_coordinate_text(const fmb_optimum *o, int j, char *text, size_t size);
FMB_API size_t fmb_optimum_ray_text(const fmb_optimum *o, int j, char *text, size_t size);

#ifdef __cplusplus
}
#endif
#endif
