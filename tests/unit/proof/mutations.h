/* mutations.h: small changes of a system and of evidence about it. */
#ifndef FMB_TEST_MUTATIONS_H
#define FMB_TEST_MUTATIONS_H

#include "proof/evidence/evidence.h"
#include "support/support.h"

typedef struct subject {
    support_rng g;
    fmb_system *s;
    fmb_evidence *e;
} subject;

/* Any index below n. */
size_t subject_any(support_rng *g, size_t n);

/* One change of some number, name or relation; false if that one found nothing to change. The
 * evidence must have a claim. */
bool subject_change(subject *u);

#endif
