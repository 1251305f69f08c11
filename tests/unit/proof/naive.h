/* naive.h: a second checker of evidence, written from docs/proof-format.md alone, to test
 * fmb_check. */
#ifndef FMB_TEST_NAIVE_H
#define FMB_TEST_NAIVE_H

#include "proof/evidence/evidence.h"
#include "support/dense.h"

/* Index of the first claim that does not hold, SIZE_MAX if all do. */
size_t naive_first_failing(const fmb_system *s, const fmb_evidence *e);

/* Does claim q, of kind WHOLE, hold if all claims of other kinds do? d: the system. */
bool naive_is_whole(const dense *d, const fmb_evidence *e, const fmb_claim *q);
/* The same where it tells an order in which variables go. */
bool naive_is_whole_by_steps(const dense *d, const fmb_evidence *e, const fmb_claim *q);

#endif
