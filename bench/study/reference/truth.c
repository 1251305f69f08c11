/* truth.c: see truth.h. */
#include "study/reference/truth.h"

#include "study/textbook/exact.h"

static fmb_status find_truth(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                             fmb_verdict *out)
{
    const fmb_frame both[2] = {*p, *q};
    fmb_system *rows = NULL;
    *out = FMB_UNKNOWN;
    fmb_status st = fmb_system_from_frames(both, 2, FMB_COORDINATES_EACH, contact, NULL, &rows);
    if (st == FMB_OK)
        st = study_textbook_solve(rows, STUDY_TRUTH_MOST_ROWS, out);
    fmb_system_free(rows);
    return st;
}

/* Does some way that was asked about this contact, and decided, say something else? */
static bool is_contradicted(const study_verdicts *v, fmb_contact contact, fmb_verdict truth)
{
    static const study_way_of_pairs WAY[2][3] = {
        [FMB_CONTACT_CLOSED] = {STUDY_FMB_CLOSED, STUDY_SAT_CLOSED, STUDY_EXACT_CLOSED},
        [FMB_CONTACT_OPEN] = {STUDY_FMB_OPEN, STUDY_SAT_OPEN, STUDY_EXACT_OPEN}};
    for (int i = 0; i < 3; i++)
        for (int order = 0; order < 2; order++) {
            fmb_verdict said = v->said[WAY[contact][i]][order];
            if ((v->asked >> WAY[contact][i] & 1) && said != FMB_UNKNOWN && said != truth)
                return true;
        }
    return false;
}

fmb_status study_truth_run(size_t n, const fmb_frame *p, const fmb_frame *q, const size_t *index,
                           const study_verdicts *verdicts, unsigned *faults,
                           const atomic_bool *stopped, uint64_t *answered, uint64_t *left)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < n && !atomic_load(stopped); i++) {
        int known = 0;
        for (int contact = 0; st == FMB_OK && contact < 2 && known == contact; contact++) {
            fmb_verdict truth;
            st = find_truth(&p[i], &q[i], (fmb_contact)contact, &truth);
            known += truth != FMB_UNKNOWN;
            if (truth != FMB_UNKNOWN &&
                is_contradicted(&verdicts[index[i]], (fmb_contact)contact, truth))
                faults[index[i]] |= STUDY_FAULT_TEXTBOOK;
        }
        ++*(known == 2 ? answered : left);
    }
    return st;
}
