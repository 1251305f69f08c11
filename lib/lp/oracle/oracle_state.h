/* oracle_state.h: the inside of an oracle. */
#ifndef FMB_LP_ORACLE_STATE_H
#define FMB_LP_ORACLE_STATE_H

#include "lp/oracle/oracle.h"
#include "lp/oracle/pivot_walk.h"
#include "lp/oracle/refined_farkas.h"
#include "lp/simplex/backend.h"

typedef enum fmb_oracle_answer {
    FMB_ANSWER_NONE = 0,
    FMB_ANSWER_POINT,
    FMB_ANSWER_CONFLICT,
    FMB_ANSWER_OPTIMUM,
    FMB_ANSWER_RAY
} fmb_oracle_answer;

struct fmb_oracle {
    fmb_run *run;
    const fmb_program *p;
    size_t n;
    fmb_backend *backend; /* made when it is first asked */
    fmb_vertex v;
    fmb_pivot_walk w;
    size_t *hint;      /* [n] a guessed basis */
    fmb_integers cost; /* [n] the last cost, times cost_unit */
    mpz_t cost_unit;
    double *price;      /* [n] roughly the cost */
    double *lean;       /* [n] roughly what the next search leans to, or NULL: not asked yet */
    bool leans;         /* it does */
    bool tight;         /* each solution lies on some row: rows are not moved in */
    bool feasible;      /* known */
    bool has_point;     /* point is some point, found for these rows or for others */
    fmb_integers point; /* [n], over point_den: a solution, strict rows included */
    mpz_t point_den;
    fmb_oracle_answer answer;
    bool has_interior_proof; /* the answer's multipliers are those of `interior_proof`, from
                                strict_interior.c */
    fmb_weights interior_proof;
};

/* closure.c: the same questions about the closure. Count a program, and tell the watcher. */
void fmb_closure_begin(fmb_oracle *o);
/* A guess, and what it comes to: REACHED, and o->point is a vertex, or CONFLICT. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_closure_guess(fmb_oracle *o, fmb_hint *h);
fmb_status fmb_closure_certify(fmb_oracle *o, fmb_hint *h, fmb_pivot_walk_end *end);
/* To a vertex where cost.x is large: REACHED, and o->point is it; or RAY. */
fmb_status fmb_closure_approach(fmb_oracle *o, const fmb_weights *cost, fmb_pivot_walk_end *end);
/* From there: REACHED, and o->point is the optimum, or RAY. */
fmb_status fmb_closure_climb(fmb_oracle *o, fmb_pivot_walk_end *end);

/* lattice_point.c: the guess h is a vertex: is there a solution of short numbers near it? If
 * *found, it is o->point. Else h is asked for again. Errors: MEMORY, LIMIT. */
fmb_status fmb_oracle_try_lattice_point(fmb_oracle *o, fmb_hint *h, bool *found);

/* strict_interior.c: the rows hold, but is there room where they are strict? *room; if there is,
 * o->point is such a solution, else o->interior_proof a conflict. face: of those with cost.x at its
 * optimum; then o->interior_proof proves cost.x < optimum. Errors: MEMORY, LIMIT. */
fmb_status fmb_oracle_find_strict_interior(fmb_oracle *o, bool face, bool *room);

#endif
