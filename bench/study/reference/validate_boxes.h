/* validate_boxes.h: boxes, times and witnesses of pairs that meet, beside the exact ones. */
#ifndef FMB_STUDY_VALIDATE_BOXES_H
#define FMB_STUDY_VALIDATE_BOXES_H

#include "study/reference/validate.h"

typedef struct study_box_bench study_box_bench;

/* [give] Errors: ARG, MEMORY. */
fmb_status study_box_bench_open(int dim, fmb_simd simd, study_box_bench **out);
void study_box_bench_close(study_box_bench *b);
void study_box_bench_cancel(study_box_bench *b);

/* n <= STUDY_VALIDATE_MOST pairs that meet; faults[n]. Adds boxes, doubtful and excess to the
 * tally. Errors: MEMORY. */
fmb_status study_box_bench_run(study_box_bench *b, size_t n, const fmb_frame *p, const fmb_frame *q,
                               unsigned *faults, study_tally *tally);

#endif
