/* proofs.h: verdicts on pairs that are proved: by a certificate (certificate.h), or where doubles
 * lead to none, by evidence of the solver that fmb_check accepts. */
#ifndef FMB_STUDY_PROOFS_H
#define FMB_STUDY_PROOFS_H

#include "study/reference/verdicts.h"

typedef struct study_proofs study_proofs;

/* [give] Errors: MEMORY. */
fmb_status study_proofs_open(int dim, study_proofs **out);
void study_proofs_close(study_proofs *s);
/* The run ends soon, whatever it then says. From any thread or signal handler. */
void study_proofs_cancel(study_proofs *s);

/* Prove what is true of pair i of n, closed and open, for verdicts[index[i]].proved; where there is
 * no proof, faults[index[i]] gets STUDY_FAULT_UNPROVED. Adds to *solved the pairs of which the
 * solver was asked. Errors: MEMORY. */
fmb_status study_proofs_run(study_proofs *s, size_t n, const fmb_frame *p, const fmb_frame *q,
                            const size_t *index, study_verdicts *verdicts, unsigned *faults,
                            uint64_t *solved);

#endif
