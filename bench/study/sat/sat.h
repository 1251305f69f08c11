/* sat.h: verdicts on pairs of frames by separating axes, the rival of elimination: its kernels take
 * the same packed blocks and leave uncertain pairs to the same exact stages. */
#ifndef FMB_STUDY_SAT_H
#define FMB_STUDY_SAT_H

#include "pair/kernels/pair_kernels.h"

/* [give] Like fmb_pair_new, but the kernels that decide verdicts use separating axes. Boxes, which
 * SAT cannot give, are computed without kernels. Errors: those of fmb_pair_new. */
fmb_status study_sat_new(int dim, const fmb_pair_options *o, fmb_pair **out);

/* The SAT kernels of the same width as those kernels of elimination. */
const fmb_pair_kernels *study_sat_kernels(const fmb_pair_kernels *like);

/* ---- for the other files of this folder ------------------------------------------------------ */

extern const fmb_pair_kernels study_sat_narrow, study_sat_avx2, study_sat_avx512;

#endif
