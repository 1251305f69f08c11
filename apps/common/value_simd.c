/* value_simd.c: the value of --simd; see value.h. */
#include "common/value.h"

#include <fmb/pair.h>

/* By asking for them: the library need not have been built with kernels for all that processors
 * have. */
static bool has_kernels(fmb_simd level)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    o.simd = level;
    fmb_status st = fmb_pair_new(2, &o, NULL, &k);
    fmb_pair_free(k);
    return st != FMB_ERR_ARG;
}

fmb_simd app_value_simd(const char *word, struct argp_state *state)
{
    static const char *const LEVEL[] = {[FMB_SIMD_AUTO] = "auto",
                                        [FMB_SIMD_PLAIN] = "plain",
                                        [FMB_SIMD_AVX2] = "avx2",
                                        [FMB_SIMD_AVX512] = "avx512",
                                        NULL};
    fmb_simd level = (fmb_simd)app_value_choice("--simd", word, LEVEL, state);
    if (!has_kernels(level))
        argp_error(state, "--simd: this processor, or this build of the library, has no %s", word);
    return level;
}
