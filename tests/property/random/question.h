/* question.h: one question about one system, repeatable: what random programs ask and what the
 * shrinker asks again. */
#ifndef FMB_TEST_QUESTION_H
#define FMB_TEST_QUESTION_H

#include "agree.h"
#include "support.h"

typedef enum question_kind {
    ASK_SOLVE,
    ASK_BOUND,
    ASK_PROJECT,
    ASK_REDUCE,
    ASK_OPTIMIZE,
    ASK_SHUFFLED, /* properties.c: the same system in another order */
    ASK_SCALED,   /* rows times positive numbers */
    ASK_RENAMED,  /* variables in another order */
    ASK_PADDED,   /* with redundant rows */
    ASK_TWICE,    /* a projection of a projection */
    ASK_KINDS,
    ASK_END = ASK_KINDS /* the box of one variable */
} question_kind;

typedef struct question {
    question_kind kind;
    fmb_options options;
    uint64_t choice; /* which variables are kept, which order is tried, ... */
    uint64_t order;  /* not 0: a random order of elimination, in place of options.order */
} question;

/* A solver for the question, which stays where it is as long as the solver is used. */
fmb_solver *question_solver(question *q);

/* The variables that choice keeps, increasing; their number. keep[dim]. */
int question_keep(uint64_t choice, int dim, int *keep);

/* Does the answer agree with the truth (and, for the later kinds, with the answer about s)? */
bool question_holds(const question *q, agree *g, fmb_solver *v, const truth *t);

/* "bound, method=fm arith=int order=given rules=kohler, choice 5" */
void question_text(const question *q, char *out, size_t size);

/* Is the answer about s wrong? self is the question: for the shrinker. */
bool question_fails(void *self, const fmb_system *s);

/* Print the disagreement g->why on stderr, with a shrunken system; seed and family come with the
 * case. */
void question_report(const question *q, agree *g, const support_case *c);

/* properties.c */
bool property_holds(const question *q, agree *g, fmb_solver *v, const truth *t);

#endif
