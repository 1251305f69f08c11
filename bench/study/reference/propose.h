/* propose.h: points, directions and prices that ought to prove where two frames meet.
 *
 * The simplex method in doubles names a basis; the basis is solved in whole numbers. Nothing here
 * has to be right: certificate.h checks all that comes out.
 */
#ifndef FMB_STUDY_PROPOSE_H
#define FMB_STUDY_PROPOSE_H

#include "study/reference/certificate.h"

typedef struct study_proposer study_proposer;

/* [give] NULL without memory. */
study_proposer *study_proposer_open(int dim);
void study_proposer_close(study_proposer *w);

/* What can be shown of the pair of s: verdicts[contact], UNKNOWN without a proof. */
void study_prove_verdicts(study_proposer *w, study_meeting *s, fmb_verdict verdict[2]);

/* Begin with the ends of a pair that meets; false if nothing will be shown. */
bool study_start_ends(study_proposer *w, const study_meeting *s);
/* Is `end` proved to be the end of the form (certificate.h)? */
bool study_prove_end(study_proposer *w, study_meeting *s, const study_form *f, double end);

#endif
