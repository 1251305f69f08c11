/* solver.h: a solver, and one query that it answers.
 *
 * A query lives on the stack of its verb: it owns the run, the parts and the oracles; the evidence
 * and the arena are the solver's. fmb_query_end releases everything on every path.
 */
#ifndef FMB_SOLVE_SOLVER_H
#define FMB_SOLVE_SOLVER_H

#include <fmb/symmetry.h>

#include "base/arena.h"
#include "base/sized.h"
#include "elim/round/elim.h"
#include "lp/oracle/oracle.h"
#include "num/weights.h"
#include "proof/evidence/evidence.h"
#include "solve/query/met_points.h"
#include "solve/query/part.h"
#include "solve/session/session_private.h"
#include "trace/run.h"

struct fmb_solver {
    fmb_mem mem;
    fmb_arena arena;
    fmb_options options;
    const fmb_rule *rule[FMB_MAX_RULES];
    int rules;
    int usual_rules; /* the number of rules if rules and steps are the defaults; else -1 */
    unsigned steps;  /* of fmb_step: options.presolve */
    fmb_chooser chooser;
    char error[160]; /* why the last call returned FMB_ERR_ARG or FMB_ERR_RULE */
    atomic_int cancel;
    fmb_permutations *symmetries; /* given for projections, or NULL */
    uint32_t *moved;       /* [permutations][dim + rows] images, during a projection; or NULL */
    const fmb_run *within; /* its deadline and cancel replace those of this solver; or NULL */
    fmb_sink sink;
    bool answered;          /* the last query ended without an error */
    fmb_evidence *evidence; /* of the last query, or NULL */
    fmb_session *session;   /* the system that is loaded, or NULL */
    fmb_row handles;        /* the last handle given to a row of a loaded system */
};

typedef struct fmb_query {
    fmb_solver *v;
    const fmb_system *s;
    fmb_run run;
    fmb_parts parts;
    fmb_evidence *evidence; /* where claims of the verdict go; NULL: none are wanted */
    fmb_evidence *claims;   /* where all other claims go: the same, or NULL */
    mpq_t *point; /* [dim] a solution for the parts decided so far; NULL if none is wanted */
    mpq_t *x;     /* [dim] scratch: a point or ray of the current part; NULL if point is */
    bool decided; /* all parts are known to be feasible */
    bool put_out; /* at a limit, the results of the current part's support queries were appended */
    fmb_met_points met;   /* of the last part whose projection had some, if wanted */
    fmb_program *program; /* [parts] rows of each part for its oracle; n == 0: not made */
    fmb_oracle **oracle;  /* [parts] the oracle of each part, or NULL */
    fmb_session *session; /* its oracle replaces these, for a system of one part; or NULL */
    bool entered;         /* the session's oracle is in use */
} fmb_query;

/* Return st, and keep the reason as the solver's error text; v may be NULL. */
__attribute__((format(printf, 3, 4))) fmb_status fmb_solver_refuse(fmb_solver *v, fmb_status st,
                                                                   const char *format, ...);
/* Check that v and s are not NULL, that there is a place for the answer (out), and that res is NULL
 * or may be written. Errors: ARG. */
fmb_status fmb_solver_expect(fmb_solver *v, const fmb_system *s, bool out, const fmb_result *res);
fmb_status fmb_solver_expect_result(fmb_solver *v, const fmb_result *res);
/* Copy the result to the caller's res, unless that is NULL. */
static inline void fmb_result_give(fmb_result *res, const fmb_result *found)
{
    if (res)
        fmb_sized_give(res, found, sizeof *found);
}
/* Is list[0..n), or NULL, a list of variables of s? Errors: ARG, whose text says `name`. */
fmb_status fmb_solver_expect_variables(fmb_solver *v, const fmb_system *s, const char *name,
                                       const int *list, int n);

/* Start: split s into parts. name is for the watcher. Errors: RULE, MEMORY. */
fmb_status fmb_query_begin(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name);
/* Like fmb_query_begin, for verbs that use only oracles. If s is the loaded system, its oracle
 * continues from its state after the last query. */
fmb_status fmb_query_resume(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name);
/* End: release everything, and turn a limit into a result. Returns the status of the verb; *res is
 * set if that is FMB_OK. */
fmb_status fmb_query_end(fmb_query *q, fmb_status st, fmb_verdict verdict, fmb_result *res);

static inline bool fmb_query_is_wide(const fmb_query *q)
{
    return q->v->options.arith == FMB_ARITH_GMP;
}

/* Are questions about a feasible system answered by elimination, without the oracle? */
static inline bool fmb_query_eliminates(const fmb_query *q)
{
    return q->v->options.method == FMB_METHOD_FM;
}

/* Request a point, with or without evidence; call before deciding. Errors: MEMORY, LIMIT. */
fmb_status fmb_query_want_point(fmb_query *q);

/* Shall the evidence prove that a projection lacks no row? */
static inline bool fmb_query_proves_complete(const fmb_query *q)
{
    return q->claims && q->v->options.evidence == FMB_EVIDENCE_WHOLE;
}

/* Decide the whole system, part by part; with `oracles`, each part by its oracle. Claims FEASIBLE
 * or INFEASIBLE. */
fmb_status fmb_query_decide(fmb_query *q, bool oracles, fmb_verdict *out);

/* Decide a tiny system on the stack, if only the verdict is wanted; else UNKNOWN. Makes no claims.
 */
fmb_verdict fmb_query_decide_tiny(fmb_query *q);

/* A record for fmb_run_tell_attempt: an engine at a task on a part, without a budget. */
fmb_attempt fmb_query_attempt(const fmb_query *q, int part, const char *engine, const char *task);

/* For a part by number: its dense rows (p->row), and its oracle. Made on the first call. */
fmb_status fmb_query_write_rows(fmb_query *q, int part);
fmb_status fmb_query_oracle(fmb_query *q, int part, fmb_oracle **out);
/* The oracle of a part that was decided feasible. LIMIT, too, if the part has no solution: then a
 * rule was unsound, and nothing can be proved. */
fmb_status fmb_query_feasible_oracle(fmb_query *q, int part, fmb_oracle **out);
/* Convert weights of a part's rows, taken as the system's integer rows, into weights of the part's
 * primitive rows. Errors, here and below: LIMIT. */
fmb_status fmb_query_take_integer_weights(fmb_query *q, const fmb_part *p, fmb_weights *w);
/* Convert weights as the oracle of a part gives them into weights of the part's primitive rows. */
fmb_status fmb_query_take_oracle_weights(fmb_query *q, const fmb_part *p, fmb_weights *w);
/* This query stops using the loaded system's oracle; forget: its state is discarded. */
void fmb_query_leave_session(fmb_query *q, bool forget);
/* Close the oracle of a part. */
void fmb_query_close_oracle(fmb_query *q, int part);
/* Close all oracles; that of the loaded system loses its state. */
void fmb_query_close_oracles(fmb_query *q);
/* Set *e to a new store with row i of the part as base row i. The part is one of the query, or its
 * dense rows exist. fmb_elim_clear it. The rule "lp" is used only if the part is known to be
 * feasible. */
fmb_status fmb_query_load(fmb_query *q, const fmb_part *p, bool feasible, fmb_elim *e);

/* options.c: the default of an option in the table, as text. */
const char *fmb_options_initial(const char *name);

/* Set the options and rules of v to those given, or to the defaults if o is NULL. Errors: ARG,
 * RULE. */
fmb_status fmb_options_read(fmb_solver *v, const fmb_options *o);
/* options.c: is every option of the table in its range? Errors: ARG. */
fmb_status fmb_options_expect(fmb_solver *v, const fmb_options *o);

/* rules.c: read options.rules and options.presolve. Below: are the rules compatible with each other
 * and with the query of that name? Errors: ARG (no such step), RULE. */
fmb_status fmb_rules_read(fmb_solver *v, const fmb_options *o);
fmb_status fmb_rules_agree(fmb_solver *v, const char *query);

/* ---- claims (claims.c): those of the verdict do nothing without evidence --------------------- */

/* Append weights of a part's rows to list, as multipliers of the system's rows; sign -1 negates
 * them. target: the part's row that they combine to; the multipliers are scaled to give this row as
 * the system holds it. Or SIZE_MAX. */
fmb_status fmb_query_push(fmb_query *q, const fmb_part *p, const fmb_weights *w, size_t target,
                          int sign, fmb_sparse_vector *list);
/* Drop the last claim if filling it failed with status st. Returns st. */
fmb_status fmb_query_finish_claim(fmb_query *q, fmb_status st);
fmb_status fmb_query_claim_infeasible(fmb_query *q, const fmb_part *p, const fmb_weights *w);
/* conflict.c: remove rows from a conflict until it is minimal. At a limit it stays as it is. */
fmb_status fmb_query_minimize_conflict(fmb_query *q, const fmb_part *p, fmb_weights *w);
/* Claim INFEASIBLE from an elimination whose row e->clash is false. */
fmb_status fmb_query_claim_clash(fmb_query *q, const fmb_part *p, const fmb_elim *e);
/* Weights over the part's rows for factor times row r of the store. Errors: MEMORY, LIMIT. */
fmb_status fmb_query_derive(fmb_query *q, const fmb_elim *e, uint32_t r, const mpq_t factor,
                            fmb_weights *w);
/* Claim IMPLIED: factor times row[n + 1], over the part's variables, holds with relation rel.
 * reverse proves the other direction of an equality; NULL: proof negated does. q has evidence. */
fmb_status fmb_query_claim_implied(fmb_query *q, const fmb_part *p, const fmb_vec *row,
                                   const mpq_t factor, fmb_rel rel, const fmb_weights *proof,
                                   const fmb_weights *reverse);
/* The constant row i is false. */
fmb_status fmb_query_claim_false_row(fmb_query *q, size_t i);
fmb_status fmb_query_claim_feasible(fmb_query *q);
/* Put a part's values x[n] into a dense vector over the system's variables. */
void fmb_query_scatter(const fmb_part *p, mpq_t *x, mpq_t *dense);
/* The query's point, with the part's coordinates replaced by x[n] (NULL: none replaced), as
 * claim->point. */
fmb_status fmb_query_attach_point(fmb_query *q, fmb_claim *claim, const fmb_part *p, mpq_t *x);

/* ---- rows of answers ------------------------------------------------------------------------- */

/* Append row r of the store, which names kept variables only, to out; its claim is made first, so
 * that every row has one. reverse as above. */
fmb_status fmb_query_put_row(fmb_query *q, const fmb_part *p, const fmb_elim *e, uint32_t r,
                             fmb_rel rel, const fmb_weights *reverse, const int *place,
                             fmb_system *out);

/* [give] The empty set over the variables of like that keep[0..n) names (NULL: the first n): the
 * row 0 <= -1. */
fmb_status fmb_empty_set(const fmb_system *like, const int *keep, int n, fmb_system **out);

#endif
