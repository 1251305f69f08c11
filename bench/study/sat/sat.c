/* sat.c: see sat.h. */
#include "study/sat/sat.h"

const fmb_pair_kernels *study_sat_kernels(const fmb_pair_kernels *like)
{
    switch (like->width) {
#ifdef FMB_PAIR_AVX2
    case 4:
        return &study_sat_avx2;
#endif
#ifdef FMB_PAIR_AVX512
    case 8:
        return &study_sat_avx512;
#endif
    default:
        return &study_sat_narrow;
    }
}

fmb_status study_sat_new(int dim, const fmb_pair_options *o, fmb_pair **out)
{
    fmb_status st = fmb_pair_new(dim, o, NULL, out);
    if (st == FMB_OK)
        fmb_pair_use_kernels(*out, &study_sat_narrow,
                             study_sat_kernels(fmb_pair_kernels_choose(o->simd)));
    return st;
}
