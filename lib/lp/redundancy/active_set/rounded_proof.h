/* rounded_proof.h: a combination of rows whose multipliers were guessed in doubles.
 *
 * Multipliers that look like simple fractions are taken for those; what they prove is then a matter
 * of integers.
 */
#ifndef FMB_LP_ROUNDED_PROOF_H
#define FMB_LP_ROUNDED_PROOF_H

#include "base/mem.h"
#include "lp/model/row.h"

/* Multipliers part[k] / all of rows index[k]. */
typedef struct fmb_rounded_proof {
    size_t *index;        /* [room] */
    int64_t *part, *unit; /* [room]; unit: own denominators */
    size_t size, room;
    int64_t all;
} fmb_rounded_proof;

/* Room for so many rows. Errors: MEMORY, LIMIT. In any case fmb_rounded_proof_clear it. */
fmb_status fmb_rounded_proof_init(fmb_rounded_proof *c, fmb_mem *mem, size_t room);
void fmb_rounded_proof_clear(fmb_rounded_proof *c, fmb_mem *mem);
/* No rows; one more, at most room of them: false if its multiplier is no simple fraction. */
void fmb_rounded_proof_begin(fmb_rounded_proof *c);
bool fmb_rounded_proof_add(fmb_rounded_proof *c, size_t row, double multiplier);
/* Does the combination, which is complete, prove row i of these over n columns: the same
 * coefficients, and no larger a right side? Once. Rows are small (num/vec.h), n <= 200. Exact. */
bool fmb_rounded_proof_holds(fmb_rounded_proof *c, size_t n, const fmb_lp_row *row, size_t i);

#endif
