/* exact.h: one pair, exactly, by the public verbs, within the limits of the options. */
#ifndef FMB_PAIR_EXACT_H
#define FMB_PAIR_EXACT_H

#include <fmb/pair.h>
#include <fmb/solve.h>

#include "pair/contact/contact_near.h"
#include "trace/run.h"

typedef struct fmb_pair_oracle {
    fmb_mem mem; /* its limit is that of a query */
    fmb_run run; /* of the query at hand: both solvers work within it */
    fmb_contact contact;
    fmb_options limits;  /* max_seconds, max_bytes */
    atomic_int cancel;   /* not 0: stop */
    fmb_solver *solver;  /* keeps no evidence */
    fmb_solver *proving; /* keeps evidence: the witness */
} fmb_pair_oracle;

/* x stays where it is. Errors: ARG, MEMORY; what was opened is closed by fmb_pair_oracle_close. */
fmb_status fmb_pair_oracle_open(fmb_pair_oracle *x, const fmb_pair_options *o,
                                const fmb_alloc *hook);
void fmb_pair_oracle_close(fmb_pair_oracle *x);

/* UNKNOWN if a limit was reached. Errors: MEMORY. */
fmb_status fmb_pair_oracle_decide(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                  fmb_verdict *out);
/* Fill in all that out, of this one pair, asks for; every end is the exact one, rounded outward.
 * The verdict becomes UNKNOWN if a limit was reached. Errors: MEMORY. */
fmb_status fmb_pair_oracle_answer(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                  const fmb_pair_answers *out);

/* The same by vertices, whatever the length of numbers. False: that was not proved, and nothing is
 * written but, of a verdict, UNKNOWN. */
bool fmb_pair_oracle_decide_at_vertices(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                        fmb_verdict *out);
bool fmb_pair_oracle_answer_at_vertices(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                        const fmb_pair_answers *out);

/* How near two frames in the plane or in space come, of which the verdict says whether they meet;
 * it becomes UNKNOWN if a limit was reached. Errors: MEMORY. */
fmb_status fmb_pair_oracle_near(fmb_pair_oracle *x, const fmb_frame *p, const fmb_frame *q,
                                fmb_verdict *verdict, fmb_pair_near *out);

#endif
