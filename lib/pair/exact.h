/* exact.h: one pair decided exactly by the public verbs, within the limits of the options. */
#ifndef FMB_PAIR_EXACT_H
#define FMB_PAIR_EXACT_H

#include <fmb/pair.h>
#include <fmb/solve.h>

#include "pair/contact/contact_near.h"
#include "trace/run.h"

typedef struct fmb_pair_oracle {
    fmb_mem mem; /* its limit is that of a query */
    fmb_run run; /* of the current query; both solvers run within it */
    fmb_contact contact;
    fmb_options limits;  /* max_seconds, max_bytes */
    atomic_int cancel;   /* not 0: stop */
    fmb_solver *solver;  /* keeps no evidence */
    fmb_solver *proving; /* keeps evidence: the witness */
} fmb_pair_oracle;

/* x must not be moved. fmb_pair_oracle_close it. Errors: ARG, MEMORY. */
fmb_status fmb_pair_oracle_open(fmb_pair_oracle *x, const fmb_pair_options *o,
                                const fmb_alloc *hook);
void fmb_pair_oracle_close(fmb_pair_oracle *x);

/* UNKNOWN if a limit was reached. Errors: MEMORY. */
fmb_status fmb_pair_oracle_decide(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                  fmb_verdict *out);
/* Fill in all that out, for this one pair, requests; every end is exact, rounded outward. The
 * verdict becomes UNKNOWN if a limit was reached. Errors: MEMORY. */
fmb_status fmb_pair_oracle_answer(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                  const fmb_pair_answers *out);

/* The two functions above by vertices, for numbers of any length. False: nothing was proved, and
 * nothing written except the verdict UNKNOWN. */
bool fmb_pair_oracle_decide_at_vertices(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                        fmb_verdict *out);
bool fmb_pair_oracle_answer_at_vertices(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                        const fmb_pair_answers *out);

/* The distance or depth of two frames in the plane or in space; *verdict says whether they meet,
 * and becomes UNKNOWN if a limit was reached. Errors: MEMORY. */
fmb_status fmb_pair_oracle_near(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                fmb_verdict *verdict, fmb_pair_near *out);

#endif
