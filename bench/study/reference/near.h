/* near.h: is a common point near some point of the world? */
#ifndef FMB_STUDY_NEAR_H
#define FMB_STUDY_NEAR_H

#include "study/reference/propose.h"

/* Is it proved that a common point is as near to x in every coordinate? Of the pair whose ends w
 * began with (study_start_ends). */
bool study_prove_near(study_proposer *w, study_meeting *s, const double *x, double near);

#endif
