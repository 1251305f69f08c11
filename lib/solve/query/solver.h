/* solver.h: a solver, and one query on its way through it.
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
    int usual_rules; /* their number, if rules and steps are those by default; else -1 */
    unsigned steps;  /* of fmb_step: options.presolve */
    fmb_chooser chooser;
    char error[160]; /* why the last call returned FMB_ERR_ARG or FMB_ERR_RULE */
    atomic_int cancel;
    fmb_permutations *symmetries; /* given for projections, or NULL */
    uint32_t *moved;       /* [permutations][dim + rows] by these, while one is made, or NULL */
    const fmb_run *within; /* whose deadline and cancel hold in place of our own, or NULL */
    fmb_sink sink;
    bool answered;          /* the last query ended without an error */
    fmb_evidence *evidence; /* of the last query, or NULL */
    fmb_session *session;   /* the system that is loaded, or NULL */
    fmb_row handles;        /* of rows of systems that were loaded, the last one */
};

typedef struct fmb_query {
    fmb_solver *v;
    const fmb_system *s;
    fmb_run run;
    fmb_parts parts;
    fmb_evidence *evidence; /* where claims of the verdict go; NULL: none are wanted */
    fmb_evidence *claims;   /* where all others go: the same, or NULL */
    mpq_t *point; /* [dim] a solution as far as parts are done; NULL unless one is wanted, ... */
    mpq_t *x;     /* [dim] ... and scratch: a point or ray of the part at hand; as evidence wants */
    bool decided; /* all parts are known to be feasible */
    bool put_out; /* what support queries found about the part at hand was put out, at a limit */
    fmb_met_points met;   /* of the projection of the last part that had some, where wanted */
    fmb_program *program; /* [parts] rows of each part for its oracle; n == 0: not made */
    fmb_oracle **oracle;  /* [parts] of each part, or NULL */
    fmb_session *session; /* whose oracle answers in place of these, for the one part; or NULL */
    bool entered;         /* it is being asked */
} fmb_query;

/* Return st, and say why; v may be NULL. */
__attribute__((format(printf, 3, 4))) fmb_status fmb_solver_refuse(fmb_solver *v, fmb_status st,
                                                                   const char *format, ...);
/* Are v, s and the place for the answer there, and may res be written, unless it is NULL? Errors:
 * ARG. */
fmb_status fmb_solver_expect(fmb_solver *v, const fmb_system *s, bool out, const fmb_result *res);
fmb_status fmb_solver_expect_result(fmb_solver *v, const fmb_result *res);
/* What was found goes to the caller, unless res is NULL. */
static inline void fmb_result_give(fmb_result *res, const fmb_result *found)
{
    if (res)
        fmb_sized_give(res, found, sizeof *found);
}
/* Is list[0..n), or NULL, a list of variables of s? Errors: ARG, by that name of the list. */
fmb_status fmb_solver_expect_variables(fmb_solver *v, const fmb_system *s, const char *name,
                                       const int *list, int n);

/* Start: split s into parts. name is for the watcher. Errors: RULE, MEMORY. */
fmb_status fmb_query_begin(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name);
/* The same for verbs that ask oracles alone. Where s is the system that is loaded, its oracle goes
 * on from where the last query left it. */
fmb_status fmb_query_resume(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name);
/* End: release everything, turn a limit into a result. The status to return from the verb; *res is
 * set when it is FMB_OK. */
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

/* A point is wanted, evidence or not: before the system is decided. Errors: MEMORY, LIMIT. */
fmb_status fmb_query_want_point(fmb_query *q);

/* Is it wanted to prove that a projection lacks no row? */
static inline bool fmb_query_proves_complete(const fmb_query *q)
{
    return q->claims && q->v->options.evidence == FMB_EVIDENCE_WHOLE;
}

/* Decide the whole system, part by part; with `oracles`, each part by its oracle. Claims FEASIBLE
 * or INFEASIBLE. */
fmb_status fmb_query_decide(fmb_query *q, bool oracles, fmb_verdict *out);

/* The verdict, where the system is tiny and nothing but that is wanted, on the stack; or UNKNOWN.
 * Nothing is claimed. */
fmb_verdict fmb_query_decide_tiny(fmb_query *q);

/* An engine at that task about a part, without a budget: for fmb_run_tell_attempt. */
fmb_attempt fmb_query_attempt(const fmb_query *q, int part, const char *engine, const char *task);

/* Parts by number: rows written out (p->row); the oracle. Made on the first call. */
fmb_status fmb_query_write_rows(fmb_query *q, int part);
fmb_status fmb_query_oracle(fmb_query *q, int part, fmb_oracle **out);
/* The same of a part that was said to have a solution. LIMIT, too, if it has none: a rule lied, and
 * nothing is proved from there on. */
fmb_status fmb_query_feasible_oracle(fmb_query *q, int part, fmb_oracle **out);
/* Weights of rows of a part, over integers of the system's rows, become such over the part's
 * primitive rows. Errors, here and below: LIMIT. */
fmb_status fmb_query_take_integer_weights(fmb_query *q, const fmb_part *p, fmb_weights *w);
/* Weights as the oracle of a part gives them become such over the part's primitive rows. */
fmb_status fmb_query_take_oracle_weights(fmb_query *q, const fmb_part *p, fmb_weights *w);
/* The oracle of the system that is loaded is asked no more by this query. */
void fmb_query_leave_session(fmb_query *q, bool forget);
/* The oracle of a part goes. */
void fmb_query_close_oracle(fmb_query *q, int part);
/* All of them go; that of a system that is loaded forgets what it knows. */
void fmb_query_close_oracles(fmb_query *q);
/* A fresh store with the rows of a part in it, row i of the part as base row i. The part is one of
 * the query, or has its rows written out. fmb_elim_clear it.
 * The rule "lp" works only where the part is known to be feasible. */
fmb_status fmb_query_load(fmb_query *q, const fmb_part *p, bool feasible, fmb_elim *e);

/* options.c: the default of an option of the table, as text. */
const char *fmb_options_initial(const char *name);

/* The options of v, and its rules, are those given, or those by default. Errors:
 * ARG, RULE. */
fmb_status fmb_options_read(fmb_solver *v, const fmb_options *o);
/* options.c: is every option of the table in its range? Errors: ARG. */
fmb_status fmb_options_expect(fmb_solver *v, const fmb_options *o);

/* rules.c: read options.rules and options.presolve; do the rules agree with each other and with the
 * query of that name? Errors: ARG (no such step), RULE. */
fmb_status fmb_rules_read(fmb_solver *v, const fmb_options *o);
fmb_status fmb_rules_agree(fmb_solver *v, const char *query);

/* ---- claims (claims.c): those of the verdict do nothing without evidence --------------------- */

/* Weights over the rows of a part, as multipliers of the system's rows; sign -1 turns them round.
 * target: the part's row whose multiple they combine to, as the multipliers shall give that row as
 * written; or SIZE_MAX. */
fmb_status fmb_query_push(fmb_query *q, const fmb_part *p, const fmb_weights *w, size_t target,
                          int sign, fmb_sparse_vector *list);
/* A claim was filled with that status: it goes if that failed. The same status. */
fmb_status fmb_query_finish_claim(fmb_query *q, fmb_status st);
fmb_status fmb_query_claim_infeasible(fmb_query *q, const fmb_part *p, const fmb_weights *w);
/* conflict.c: leave out rows of a conflict until none can be. At a limit it stays as it is. */
fmb_status fmb_query_minimize_conflict(fmb_query *q, const fmb_part *p, fmb_weights *w);
/* The same from an elimination whose rows clash. */
fmb_status fmb_query_claim_clash(fmb_query *q, const fmb_part *p, const fmb_elim *e);
/* Weights over the part's rows for factor times row r of the store. Errors: MEMORY, LIMIT. */
fmb_status fmb_query_derive(fmb_query *q, const fmb_elim *e, uint32_t r, const mpq_t factor,
                            fmb_weights *w);
/* IMPLIED: factor times row[n + 1], over the part's variables, holds with that relation. reverse
 * proves the other direction of an equality; NULL: proof, turned round, does. Evidence is wanted.
 */
fmb_status fmb_query_claim_implied(fmb_query *q, const fmb_part *p, const fmb_vec *row,
                                   const mpq_t factor, fmb_rel rel, const fmb_weights *proof,
                                   const fmb_weights *reverse);
/* The constant row i is false. */
fmb_status fmb_query_claim_false_row(fmb_query *q, size_t i);
fmb_status fmb_query_claim_feasible(fmb_query *q);
/* Copy a part's values x[n] into a dense vector over the system's variables. */
void fmb_query_scatter(const fmb_part *p, mpq_t *x, mpq_t *dense);
/* The query's point, with the part's coordinates replaced by x[n] (NULL: none replaced), as
 * claim->point. */
fmb_status fmb_query_attach_point(fmb_query *q, fmb_claim *claim, const fmb_part *p, mpq_t *x);

/* ---- rows of answers ------------------------------------------------------------------------- */

/* Append row r of the store, which names kept variables only, to out; a claim first, so that no row
 * goes without. reverse as above. */
fmb_status fmb_query_put_row(fmb_query *q, const fmb_part *p, const fmb_elim *e, uint32_t r,
                             fmb_rel rel, const fmb_weights *reverse, const int *place,
                             fmb_system *out);

/* [give] The empty set over the variables of like that keep[0..n) names (NULL: the first n): the
 * row 0 <= -1. */
fmb_status fmb_empty_set(const fmb_system *like, const int *keep, int n, fmb_system **out);

#endif
