/* verbs.h: the queries under one roof, for tests that do the same to each. */
#ifndef FMB_TEST_VERBS_H
#define FMB_TEST_VERBS_H

#include <fmb/gmp.h>

enum { VERB_ANSWER = 1 << 18 };

typedef struct verb {
    const char *name;
    /* Ask, and write the answer and its evidence to out[VERB_ANSWER] if all went well. Checks that
     * out arguments are untouched on failure. */
    fmb_status (*ask)(fmb_solver *v, const fmb_system *s, fmb_result *r, char *out);
} verb;

extern const verb VERBS[];
extern const int VERBS_COUNT;

#endif
