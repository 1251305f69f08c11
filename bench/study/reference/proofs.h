/* proofs.h: exact verdicts on pairs, each with evidence that fmb_check accepts. */
#ifndef FMB_STUDY_PROOFS_H
#define FMB_STUDY_PROOFS_H

#include "study/reference/verdicts.h"

typedef struct study_proofs study_proofs;

/* [give] Errors: MEMORY. */
fmb_status study_proofs_open(study_proofs **out);
void study_proofs_close(study_proofs *s);
/* The run ends soon, whatever it then says. From any thread or signal handler. */
void study_proofs_cancel(study_proofs *s);

/* Prove pair i of n, closed and open, for verdicts[index[i]]: where the exact way says otherwise,
 * or there is no proof, faults[index[i]] gets STUDY_FAULT_UNPROVED. Errors: MEMORY. */
fmb_status study_proofs_run(study_proofs *s, size_t n, const fmb_frame *p, const fmb_frame *q,
                            const size_t *index, const study_verdicts *verdicts, unsigned *faults);

#endif
