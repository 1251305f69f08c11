/* agree.h: does an answer of the library agree with the ground truth (bench/study/textbook)?
 *
 * Each agree_* function asks a solver one question and judges everything that comes back: verdict,
 * ends, rows, evidence. The ground truth gives up on systems that grow too large; what it could not
 * judge is counted, and is not a disagreement.
 */
#ifndef FMB_TEST_AGREE_H
#define FMB_TEST_AGREE_H

#include "study/textbook/exact.h"

#include "rows.h"

typedef struct agree {
    size_t max_rows;    /* of the ground truth [rows] */
    char why[240];      /* the last disagreement */
    uint64_t questions; /* asked of the library */
    uint64_t unjudged;  /* parts of answers that the ground truth was too small for */
    uint64_t by_proof;  /* systems too large for it: the truth is a checked proof of the oracle's */
    uint64_t undecided; /* queries that ended with a stop other than DONE */
} agree;

/* The truth about one system. */
typedef struct truth {
    const fmb_system *s;
    fmb_verdict verdict;          /* UNKNOWN: too large */
    study_textbook_end (*end)[2]; /* [dim] if feasible and within reach, else NULL */
} truth;

void truth_init(truth *t, const fmb_system *s, size_t max_rows);
void truth_clear(truth *t);

/* Each returns false, with g->why filled, on a disagreement. Results, where a place for them is
 * given, are the caller's to free (NULL if undecided). */
bool agree_solve(agree *g, fmb_solver *v, const truth *t);
bool agree_bound(agree *g, fmb_solver *v, const truth *t);
/* The box of variable var alone. */
bool agree_end(agree *g, fmb_solver *v, const truth *t, int var);
/* The optimum of a form that choice decides on. */
bool agree_optimize(agree *g, fmb_solver *v, const truth *t, uint64_t choice);
bool agree_project(agree *g, fmb_solver *v, const truth *t, const int *keep, int n,
                   fmb_system **out);
/* p and q, projections of different systems, or in different ways, are the same, row by row; NULL:
 * a limit was reached. */
bool agree_form(agree *g, const fmb_system *p, const fmb_system *q);
bool agree_reduce(agree *g, fmb_solver *v, const truth *t, fmb_system **out);

/* Every row of b follows from a, where variable j of b is variable map[j] of a. */
bool agree_implies(agree *g, const fmb_system *a, const fmb_system *b, const int *map);
/* The same solutions. */
bool agree_same(agree *g, const fmb_system *a, const fmb_system *b);
/* No row of s follows from the others, and no inequality is an equality in disguise. */
bool agree_irredundant(agree *g, const fmb_system *s);

#endif
