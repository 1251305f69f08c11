/* verdict.c: verdicts and rows with proofs; see support.h. */
#include <stdlib.h>

#include <fmb/fmb.h>

#include "dense.h"
#include "support/must.h"

/* [give] The evidence of the last query, which fmb_check accepts. */
static fmb_evidence *accepted_evidence(const fmb_solver *v, const fmb_system *s,
                                       fmb_judgement *found)
{
    fmb_evidence *e = NULL;
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, found));
    if (found->accepted)
        return e;
    fprintf(stderr, "tests/support: claim %zu: %s\n", found->claim, found->reason);
    abort();
}

fmb_verdict support_proved_verdict(const fmb_system *s)
{
    fmb_solver *v = must_open((fmb_options){.evidence = FMB_EVIDENCE_ALL});
    fmb_result r = {.size = sizeof r};
    fmb_judgement j = {.size = sizeof j};
    must(fmb_solve(v, s, &r));
    fmb_evidence_free(accepted_evidence(v, s, &j));
    fmb_solver_free(v);
    return j.verdict;
}

size_t support_proved_rows(const fmb_solver *v, const fmb_system *s)
{
    fmb_judgement j = {.size = sizeof j};
    fmb_evidence *e = accepted_evidence(v, s, &j);
    size_t rows = 0;
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        rows += fmb_evidence_kind(e, i) == FMB_CLAIM_IMPLIED;
    fmb_evidence_free(e);
    return rows;
}
