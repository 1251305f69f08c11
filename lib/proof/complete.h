/* complete.h: the check of claims WHOLE: no row of a projection is missing.
 *
 * The rows are the claims IMPLIED of the same evidence that contain kept variables only; the
 * corners, points and rays, are its claims CORNER. That these claims hold is checked elsewhere.
 */
#ifndef FMB_PROOF_COMPLETE_H
#define FMB_PROOF_COMPLETE_H

#include "proof/evidence/evidence.h"
#include "proof/lattice.h"

/* Does claim q, of kind WHOLE, follow from the claims that it relies on? *why: NULL, or why not. If
 * all that is missing is a solution above the relative interior of some face, on[claims] (or NULL)
 * marks the corners on that face; otherwise none. Errors: MEMORY, LIMIT, and the status of poll. */
fmb_status fmb_complete_check(const fmb_system *s, const fmb_evidence *e, const fmb_claim *q,
                              fmb_mem *mem, const fmb_poll *poll, const char **why, bool *on);

/* Does the claim contain only variables with kept[dim] set? */
bool fmb_complete_names_only(const fmb_claim *c, int dim, const bool *kept);

#endif
