/* answer.h: the proved answer to a problem of the benchmark. */
#ifndef QUALIFY_ANSWER_H
#define QUALIFY_ANSWER_H

#include "fmb-qualify/benchmark/sha256.h"
#include "study/benchmark/benchmark.h"

typedef struct qualify_answer {
    fmb_verdict verdict;
    size_t equations, inequalities, strict; /* of the projection; strict are also inequalities */
    /* Digest of the projection as `fmb project --to ine` prints it; if no variable is kept, of the
     * verdict's word and a newline. */
    char digest[QUALIFY_SHA256_TEXT];
} qualify_answer;

/* The checker accepts the answer, for a projection also that no row is missing; else an exit code,
 * after a message with the name. APP_UNDECIDED: the solver was cancelled. */
int qualify_answer_find(fmb_solver *v, const char *name, const study_projection *p,
                        qualify_answer *out);

#endif
