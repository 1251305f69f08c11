/* samples.h: systems with evidence, right and wrong, for the tests of the proof room. */
#ifndef FMB_TEST_PROOF_SAMPLES_H
#define FMB_TEST_PROOF_SAMPLES_H

#include "proof/evidence/evidence.h"

typedef struct proof_sample {
    const char *name;
    const char *system; /* names of the variables, then a row a line: "1 -2 <= 3/4" */
    const char *claims; /* the text form behind the two lines of its header */
    const char *why;    /* NULL: right; else a part of the reason for which it is rejected */
    fmb_verdict verdict;
} proof_sample;

extern const proof_sample proof_samples[];
extern const size_t proof_samples_count;

/* From text as above. The caller frees it. */
fmb_system *proof_system(const char *text, const fmb_alloc *mem);
/* Read evidence from text, the header included if whole. */
fmb_status proof_parse(const fmb_system *s, const char *text, fmb_evidence **out, fmb_where *where);
/* The same with the right header put before the claims; insists on success. */
fmb_evidence *proof_claims(const fmb_system *s, const char *claims);
/* The text form; the caller frees it. Insists on success. */
char *proof_text(const fmb_system *s, const fmb_evidence *e);

/* The same claims once more, to be changed; by way of the text. */
fmb_evidence *proof_copy(const fmb_system *s, const fmb_evidence *e);

#endif
