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
    fmb_backend *backend; /* made at the first query */
    fmb_vertex v;
    fmb_pivot_walk w;
    size_t *hint;      /* [n] a guessed basis */
    fmb_integers cost; /* [n] the last cost, times cost_unit */
    mpz_t cost_unit;
    int cost_bits;      /* the longest of cost has so many bits */
    double *price;      /* [n] cost / 2^cost_bits in doubles */
    double *lean;       /* [n] preferred cost of the next search in doubles, or NULL */
    bool leans;         /* the next search has one */
    bool tight;         /* each solution lies on some row: right sides are not lowered */
    bool feasible;      /* known */
    bool has_point;     /* `point` is a point found for these or for other rows */
    fmb_integers point; /* [n], over point_den: a solution, strict rows included */
    mpz_t point_den;
    fmb_oracle_answer answer;
    bool has_interior_proof; /* the answer's multipliers are those of `interior_proof`, from
                                strict_interior.c */
    fmb_weights interior_proof;
};

/* closure.c: the same queries for the closure. Count a linear program, and notify the watcher. */
void fmb_closure_begin(fmb_oracle *o);
/* A guess, and its certification: REACHED, with o->point a vertex, or CONFLICT. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_closure_guess(fmb_oracle *o, fmb_hint *h);
fmb_status fmb_closure_certify(fmb_oracle *o, fmb_hint *h, fmb_pivot_walk_end *end);
/* Go to a vertex where cost.x is large: REACHED, with o->point there; or RAY. */
fmb_status fmb_closure_approach(fmb_oracle *o, const fmb_weights *cost, fmb_pivot_walk_end *end);
/* Continue from there: REACHED, with o->point the optimum; or RAY. */
fmb_status fmb_closure_climb(fmb_oracle *o, fmb_pivot_walk_end *end);

/* lattice_point.c: the guess h is a vertex: is there a solution with short numbers near it? *found:
 * it is o->point. Otherwise h is guessed again. Errors: MEMORY, LIMIT. */
fmb_status fmb_oracle_try_lattice_point(fmb_oracle *o, fmb_hint *h, bool *found);

/* strict_interior.c: the closure has points; is there one that satisfies strict rows strictly?
 * *room: yes, o->point; otherwise o->interior_proof is a conflict. face: only points with optimal
 * cost.x are considered, and o->interior_proof proves cost.x < optimum. Errors: MEMORY, LIMIT. */
fmb_status fmb_oracle_find_strict_interior(fmb_oracle *o, bool face, bool *room);

#endif
