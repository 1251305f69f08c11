/* agree_inside.h: what agree.c and agree_rows.c share. */
#ifndef FMB_TEST_AGREE_INSIDE_H
#define FMB_TEST_AGREE_INSIDE_H

#include "agree.h"

/* Fill g->why and return false. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool differ(agree *g, const char *format, ...);

/* Status, verdict, stop and trust of an answer. */
bool judge_result(agree *g, fmb_status st, const fmb_result *r, const truth *t);
/* The evidence of the last query: accepted, and not against the verdict. The caller frees *out. */
bool judge_evidence(agree *g, fmb_solver *v, const fmb_system *s, const fmb_result *r,
                    fmb_evidence **out);
/* It holds count claims of kinds a and b together. */
bool judge_claims(agree *g, const fmb_evidence *e, fmb_claim_kind a, fmb_claim_kind b,
                  size_t count);

#endif
