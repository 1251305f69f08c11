/* sat.h: pairs of frames asked by separating axes, the rival of elimination: its kernels answer the
 * same blocks, packed in the same way, and leave what they are not certain of to the same ladder.
 */
#ifndef FMB_STUDY_SAT_H
#define FMB_STUDY_SAT_H

#include "pair/kernels/pair_kernels.h"

/* [give] fmb_pair_new, but for verdicts by kernels: these are separating axes. Boxes, which SAT has
 * not got, are answered without kernels. Errors: those of fmb_pair_new. */
fmb_status study_sat_new(int dim, const fmb_pair_options *o, fmb_pair **out);

/* As many pairs at a time as those kernels of elimination answer. */
const fmb_pair_kernels *study_sat_kernels(const fmb_pair_kernels *like);

/* ---- for the other files of this folder ------------------------------------------------------ */

extern const fmb_pair_kernels study_sat_narrow, study_sat_avx2, study_sat_avx512;

#endif
