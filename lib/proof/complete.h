/* complete.h: the check of claims WHOLE: of a projection, no row is missing.
 *
 * The rows are what the claims IMPLIED of the same evidence say that name kept variables only; the
 * corners are its claims CORNER, points and rays. That all of these hold is checked elsewhere.
 */
#ifndef FMB_PROOF_COMPLETE_H
#define FMB_PROOF_COMPLETE_H

#include "proof/evidence/evidence.h"
#include "proof/lattice.h"

/* Does claim q, of kind WHOLE, follow from the claims that it leans on? *why: NULL, or why not.
 * on[claims], or NULL: where all that is missing is a solution above the relative interior of some
 * face, the corners on that; else none. Errors: MEMORY, LIMIT, and what poll says. */
fmb_status fmb_complete_check(const fmb_system *s, const fmb_evidence *e, const fmb_claim *q,
                              fmb_mem *mem, const fmb_poll *poll, const char **why, bool *on);

/* Does the claim name only variables with kept[dim] set? */
bool fmb_complete_names_only(const fmb_claim *c, int dim, const bool *kept);

#endif
