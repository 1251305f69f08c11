/* digest.h: summary of the runs of one way over some systems, and its ratios to a base way. */
#ifndef FMB_STUDY_DIGEST_H
#define FMB_STUDY_DIGEST_H

#include "study/clock/ratio.h"
#include "study/grid/grid.h"

typedef struct study_digest {
    size_t systems, decided, stopped, refused, wrong; /* by counts or by verdict */
    /* Means over the systems decided, 0 if none was. */
    double pairs, made, kept, lived, peak, held;
    double dropped[STUDY_MOST_NAMES];
    /* Over way base, on the systems that both decided: ratios of totals; NaN if there are none.
     * only: systems that this way decided and base did not. */
    size_t both, only;
    double kept_ratio, lived_ratio;
    /* Time over that of way base, on the systems that at least one of them solved. A run that gave
     * up counts with its time until then: the ratio is too large if base gave up, too small if this
     * way did. */
    size_t timed, base_gave_up, gave_up; /* systems */
    study_ratio total, median;           /* of totals; median of the systems' ratios */
    double chance; /* that so many or more of the systems gain if gain and loss are equally likely:
                      the sign test, one-sided */
} study_digest;

/* Which samples count. */
typedef bool study_filter(const void *self, const study_sample *sample);

/* Errors: MEMORY. */
fmb_status study_digest_make(const study_grid *g, size_t way, size_t base, study_filter *filter,
                             const void *self, study_digest *out);

#endif
