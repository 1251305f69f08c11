/* validate_contacts.h: depths, distances, normals, nearest points and rows between, beside the
 * exact ones. */
#ifndef FMB_STUDY_VALIDATE_CONTACTS_H
#define FMB_STUDY_VALIDATE_CONTACTS_H

#include "study/reference/validate.h"

typedef struct study_contact_bench study_contact_bench;

/* [give] dim 2 or 3. Errors: ARG, MEMORY. */
fmb_status study_contact_bench_open(int dim, fmb_simd simd, study_contact_bench **out);
void study_contact_bench_close(study_contact_bench *b);
void study_contact_bench_cancel(study_contact_bench *b);

/* n <= STUDY_VALIDATE_MOST pairs, in both orders, one of them by sets; adds to faults[index[i]],
 * and contacts and contacts_open to the tally. Errors: MEMORY. */
fmb_status study_contact_bench_run(study_contact_bench *b, size_t n, const fmb_frame *p,
                                   const fmb_frame *q, const size_t *index, unsigned *faults,
                                   study_tally *tally);

#endif
