/* by_elimination.h: the check of claims WHOLE that tell in what order variables go, and of claims
 * FOLLOWS, which those lean on.
 *
 * CLAIM. Claims IMPLIED that name kept variables only are rows that are true of the projection.
 * Let Q be the set of points that satisfy them. Variables that are not kept are eliminated from the
 * system, and each row that is left names kept variables only, and is true of all of Q. Then Q is
 * the projection.
 *
 * PROOF. A point of Q satisfies all rows that are left, so it is the image of a solution
 * (elimination.h). END
 *
 * A row a.x <= b that is left is true of Q if it is a multiple of one of those claims, or of a
 * claim FOLLOWS that leans on such claims alone, which says as much. (An equation: both ways.)
 */
#ifndef FMB_PROOF_BY_ELIMINATION_H
#define FMB_PROOF_BY_ELIMINATION_H

#include "proof/elimination.h"
#include "proof/evidence/evidence.h"

/* Takes a.x <= b, or < b, that is left and no claim says: z[k + 1] over kept variables, as claim q
 * names them. What it returns ends the search, unless it is OK. */
typedef struct fmb_unsaid {
    fmb_status (*tell)(void *self, const fmb_integers *z, bool strict);
    void *self;
} fmb_unsaid;

/* Does claim q, of kind WHOLE, follow, by its steps, from the claims that it leans on, if these
 * hold? *why: NULL, or why not. Errors: MEMORY, LIMIT, and what poll says; here and below. */
fmb_status fmb_by_elimination_check(const fmb_system *s, const fmb_evidence *e, const fmb_claim *q,
                                    fmb_mem *mem, const fmb_poll *poll, const char **why);
/* The same where the elimination has been done; with `unsaid`, unless it is NULL, rows that no
 * claim says are told, and are no reason why not. */
fmb_status fmb_by_elimination_match(const fmb_elimination *of, const fmb_evidence *e,
                                    const fmb_claim *q, const fmb_unsaid *unsaid, const char **why);

/* Does claim q, of kind FOLLOWS, follow from the claims IMPLIED that it names? Its terms are of
 * variables that there are. */
fmb_status fmb_follows_check(const fmb_evidence *e, const fmb_claim *q, fmb_mem *mem,
                             const fmb_poll *poll, const char **why);

#endif
