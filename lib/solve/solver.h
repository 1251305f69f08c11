/* solver.h: a solver, and one query on its way through it.
 *
 * A query lives on the stack of its verb: it owns the run, the parts and the oracles; the evidence
 * and the arena are the solver's. fmb_query_end releases everything on every path.
 */
#ifndef FMB_SOLVE_SOLVER_H
#define FMB_SOLVE_SOLVER_H

#include "base/arena.h"
#include "elim/elim.h"
#include "lp/lp.h"
#include "num/weights.h"
#include "proof/evidence.h"
#include "solve/part.h"
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
    char trouble[160]; /* why the last query returned FMB_ERR_RULE */
    atomic_int cancel;
    fmb_sink sink;
    bool answered;          /* the last query ended without an error */
    fmb_evidence *evidence; /* of the last query, or NULL */
};

typedef struct fmb_query {
    fmb_solver *v;
    const fmb_system *s;
    fmb_run run;
    fmb_parts parts;
    fmb_evidence *evidence; /* where claims go; NULL: none are wanted */
    mpq_t *point;           /* [dim] a solution as far as parts are done; NULL without evidence */
    mpq_t *x;     /* [dim] scratch: a point or ray of the part at hand; NULL without evidence */
    bool decided; /* all parts are known to be feasible */
    fmb_lp **lp;  /* [parts] oracle of each part, or NULL */
} fmb_query;

/* Start: split s into parts. name is for the watcher. Errors: RULE, MEMORY. */
fmb_status fmb_query_begin(fmb_query *q, fmb_solver *v, const fmb_system *s, const char *name);
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
    fmb_method method = q->v->options.method;
    return method == FMB_METHOD_FM || method == FMB_METHOD_FMPLEX;
}

/* Decide the whole system, part by part; with `oracles`, each part keeps a feasible dictionary in
 * q->lp. Claims FEASIBLE or INFEASIBLE. */
fmb_status fmb_query_decide(fmb_query *q, bool oracles, fmb_verdict *out);

/* The oracle of a part, made on the first call. */
fmb_status fmb_query_oracle(fmb_query *q, int part, fmb_lp **out);

/* A fresh store with the rows of a part in it, row i of the part as base row i. fmb_elim_clear it.
 * The rule "lp" works only where the part is known to be feasible. */
fmb_status fmb_query_load(fmb_query *q, const fmb_part *p, bool feasible, fmb_elim *e);

/* options.c: the default of an option of the table, as text. */
const char *fmb_options_initial(const char *name);

/* rules.c: read options.rules and options.presolve; do the rules agree with each other and with the
 * query of that name? Errors: ARG (no such step), RULE. */
fmb_status fmb_rules_read(fmb_solver *v, const fmb_options *o);
fmb_status fmb_rules_agree(fmb_solver *v, const char *query);

/* ---- claims (claims.c): all do nothing without evidence -------------------------------------- */

/* Weights over the rows of a part, as multipliers of the system's rows; sign -1 turns them round.
 * target: the part's row whose multiple they combine to, as the multipliers shall give that row as
 * written; or SIZE_MAX. */
fmb_status fmb_query_push(fmb_query *q, const fmb_part *p, const fmb_weights *w, size_t target,
                          int sign, fmb_sparse *list);
fmb_status fmb_query_claim_infeasible(fmb_query *q, const fmb_part *p, const fmb_weights *w);
/* The same from an elimination whose rows clash. */
fmb_status fmb_query_claim_clash(fmb_query *q, const fmb_part *p, const fmb_elim *e);
/* The constant row i is false. */
fmb_status fmb_query_claim_false_row(fmb_query *q, size_t i);
fmb_status fmb_query_claim_feasible(fmb_query *q);
/* Copy a part's values x[n] into a dense vector over the system's variables. */
void fmb_query_scatter(const fmb_part *p, mpq_t *x, mpq_t *dense);
/* The query's point, with the part's coordinates replaced by x[n] (NULL: none replaced), as
 * claim->point. */
fmb_status fmb_query_attach_point(fmb_query *q, fmb_claim *claim, const fmb_part *p, mpq_t *x);

/* ---- small ----------------------------------------------------------------------------------- */

/* n rationals, 0 at first. */
fmb_status fmb_vector_new(mpq_t **out, size_t n, fmb_mem *mem);
void fmb_vector_free(mpq_t *x, size_t n, fmb_mem *mem);

/* [give] The empty set over the variables of like that keep[0..n) names (NULL: the first n): the
 * row 0 <= -1. */
fmb_status fmb_empty_set(const fmb_system *like, const int *keep, int n, fmb_system **out);

#endif
