/* by_elimination.h: checks claims WHOLE that give an order of elimination, and claims FOLLOWS, on
 * which the former rely.
 *
 * CLAIM. Claims IMPLIED that contain kept variables only are rows that hold on the projection. Let
 * Q be the set of points that satisfy these. If the variables that are not kept are eliminated, and
 * each remaining row contains kept variables only and holds on all of Q, then Q is the projection.
 *
 * PROOF. A point of Q satisfies all remaining rows, so it is the image of a solution
 * (elimination.h). END
 *
 * A remaining row a.x <= b holds on Q if one of those claims, or a claim FOLLOWS that relies on
 * them alone, has a multiple of its left side and a bound as tight. (For an equation: both ways.)
 */
#ifndef FMB_PROOF_BY_ELIMINATION_H
#define FMB_PROOF_BY_ELIMINATION_H

#include "proof/elimination.h"
#include "proof/evidence/evidence.h"

/* A callback for a remaining row a.x <= b, or < b, that no claim implies: z[k + 1] over the kept
 * variables in the order of claim q. Any status but OK ends the search. */
typedef struct fmb_unsaid {
    fmb_status (*tell)(void *self, const fmb_integers *z, bool strict);
    void *self;
} fmb_unsaid;

/* Does claim q, of kind WHOLE, follow by its steps from the claims that it relies on, if these
 * hold? *why: NULL, or why not. Errors: MEMORY, LIMIT, and the status of poll; here and below. */
fmb_status fmb_by_elimination_check(const fmb_system *s, const fmb_evidence *e, const fmb_claim *q,
                                    fmb_mem *mem, const fmb_poll *poll, const char **why);
/* The same for a finished elimination; if `unsaid` is not NULL, it is called for each row that no
 * claim implies, and such rows are no reason why not. */
fmb_status fmb_by_elimination_match(const fmb_elimination *of, const fmb_evidence *e,
                                    const fmb_claim *q, const fmb_unsaid *unsaid, const char **why);

/* Does claim q, of kind FOLLOWS, follow from the claims IMPLIED that it names? The variables of its
 * terms must exist. */
fmb_status fmb_follows_check(const fmb_evidence *e, const fmb_claim *q, fmb_mem *mem,
                             const fmb_poll *poll, const char **why);

#endif
