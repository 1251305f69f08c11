/* verdict.c: a verdict that is proved; see support.h. */
#include <stdlib.h>

#include <fmb/fmb.h>

#include "dense.h"
#include "support/must.h"

fmb_verdict support_proved_verdict(const fmb_system *s)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    if (!j.accepted) {
        fprintf(stderr, "tests/support: %s\n", j.reason);
        abort();
    }
    fmb_evidence_free(e);
    fmb_solver_free(v);
    return j.verdict;
}
