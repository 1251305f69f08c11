/* proofs.c: see proofs.h. */
#include "study/reference/proofs.h"

#include <stdatomic.h>
#include <stdlib.h>

#include <fmb/solve.h>

#include "study/reference/propose.h"

struct study_proofs {
    study_proposer *proposer;
    study_meeting meeting;
    fmb_solver *solver;
    atomic_bool stopped;
};

fmb_status study_proofs_open(int dim, study_proofs **out)
{
    study_proofs *s = calloc(1, sizeof *s);
    fmb_options o = {.size = sizeof o};
    if (!s)
        return FMB_ERR_MEMORY;
    o.evidence = FMB_EVIDENCE_ALL;
    study_meeting_init(&s->meeting);
    s->proposer = study_proposer_open(dim);
    fmb_status st = s->proposer ? fmb_solver_new(&o, NULL, &s->solver) : FMB_ERR_MEMORY;
    if (st == FMB_OK)
        *out = s;
    else
        study_proofs_close(s);
    return st;
}

void study_proofs_close(study_proofs *s)
{
    if (!s)
        return;
    fmb_solver_free(s->solver);
    study_proposer_close(s->proposer);
    study_meeting_clear(&s->meeting);
    free(s);
}

void study_proofs_cancel(study_proofs *s)
{
    atomic_store(&s->stopped, true);
    fmb_solver_cancel(s->solver);
}

/* UNKNOWN without a proof. */
static fmb_status prove_by_solver(study_proofs *s, const fmb_frame *p, const fmb_frame *q,
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

static fmb_status prove(study_proofs *s, const fmb_frame *p, const fmb_frame *q,
                        fmb_verdict proved[2], uint64_t *solved)
{
    bool asked = false;
    fmb_status st = FMB_OK;
    proved[0] = proved[1] = FMB_UNKNOWN;
    if (study_meeting_load(&s->meeting, p, q))
        study_prove_verdicts(s->proposer, &s->meeting, proved);
    for (int contact = 0; contact < 2 && st == FMB_OK; contact++)
        if (proved[contact] == FMB_UNKNOWN) {
            asked = true;
            st = prove_by_solver(s, p, q, (fmb_contact)contact, &proved[contact]);
        }
    *solved += asked;
    return st;
}

fmb_status study_proofs_run(study_proofs *s, size_t n, const fmb_frame *p, const fmb_frame *q,
                            const size_t *index, study_verdicts *verdicts, unsigned *faults,
                            uint64_t *solved)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < n && !atomic_load(&s->stopped); i++) {
        fmb_verdict *proved = verdicts[index[i]].proved;
        st = prove(s, &p[i], &q[i], proved, solved);
        if (proved[0] == FMB_UNKNOWN || proved[1] == FMB_UNKNOWN)
            faults[index[i]] |= STUDY_FAULT_UNPROVED;
    }
    return st;
}
