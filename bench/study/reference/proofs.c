/* proofs.c: see proofs.h. */
#include "study/reference/proofs.h"

#include <stdatomic.h>
#include <stdlib.h>

#include <fmb/solve.h>

struct study_proofs {
    fmb_solver *solver;
    atomic_bool stopped;
};

fmb_status study_proofs_open(study_proofs **out)
{
    study_proofs *s = calloc(1, sizeof *s);
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_ALL;
    fmb_status st = s ? fmb_solver_new(&o, NULL, &s->solver) : FMB_ERR_MEMORY;
    if (st == FMB_OK)
        *out = s;
    else
        study_proofs_close(s);
    return st;
}

void study_proofs_close(study_proofs *s)
{
    if (s)
        fmb_solver_free(s->solver);
    free(s);
}

void study_proofs_cancel(study_proofs *s)
{
    atomic_store(&s->stopped, true);
    fmb_solver_cancel(s->solver);
}

/* UNKNOWN without a proof. */
static fmb_status prove(study_proofs *s, const fmb_frame *p, const fmb_frame *q,
                        fmb_contact contact, fmb_verdict *out)
{
    const fmb_frame both[2] = {*p, *q};
    fmb_system *rows = NULL;
    fmb_evidence *e = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_judgement j = {.size = sizeof j};
    fmb_status st = fmb_system_from_frames(both, 2, FMB_COORDINATES_EACH, contact, NULL, &rows);
    if (st == FMB_OK)
        st = fmb_solve(s->solver, rows, &res);
    if (st == FMB_OK && res.verdict != FMB_UNKNOWN)
        st = fmb_solver_evidence(s->solver, &e);
    if (st == FMB_OK && e)
        st = fmb_check(rows, e, &j);
    *out = j.accepted ? j.verdict : FMB_UNKNOWN;
    fmb_evidence_free(e);
    fmb_system_free(rows);
    return st;
}

fmb_status study_proofs_run(study_proofs *s, size_t n, const fmb_frame *p, const fmb_frame *q,
                            const size_t *index, const study_verdicts *verdicts, unsigned *faults)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < n; i++)
        for (int open = 0; st == FMB_OK && open < 2 && !atomic_load(&s->stopped); open++) {
            fmb_verdict proved = FMB_UNKNOWN;
            int way = open ? STUDY_EXACT_OPEN : STUDY_EXACT_CLOSED;
            st = prove(s, &p[i], &q[i], open ? FMB_CONTACT_OPEN : FMB_CONTACT_CLOSED, &proved);
            if (proved == FMB_UNKNOWN || proved != verdicts[index[i]].said[way][0])
                faults[index[i]] |= STUDY_FAULT_UNPROVED;
        }
    return st;
}
