/* truth.h: the textbook truth on pairs: plain elimination on rationals, which shares nothing with
 * the library but the system that says where two frames meet. */
#ifndef FMB_STUDY_TRUTH_H
#define FMB_STUDY_TRUTH_H

#include <stdatomic.h>

#include "study/reference/verdicts.h"

/* Rows alive beyond which a pair is left: doubly exponential cost is not for everybody. */
enum { STUDY_TRUTH_MOST_ROWS = 1000 };

/* Ask pair i of n, closed and open, for verdicts[index[i]]: where any way that decided says
 * otherwise, faults[index[i]] gets STUDY_FAULT_TEXTBOOK. *answered gets the pairs that were small
 * enough for both, *left the others. Ends soon once *stopped. Errors: MEMORY. */
fmb_status study_truth_run(size_t n, const fmb_frame *p, const fmb_frame *q, const size_t *index,
                           const study_verdicts *verdicts, unsigned *faults,
                           const atomic_bool *stopped, uint64_t *answered, uint64_t *left);

#endif
