/* implicit_equalities.h: equalities that depend on others, and inequalities that always hold with
 * equality.
 */
#ifndef FMB_LP_IMPLICIT_EQUALITIES_H
#define FMB_LP_IMPLICIT_EQUALITIES_H

#include "lp/redundancy/pruner.h"

/* Rows that are equalities, of which those go that depend on others. Errors: MEMORY, LIMIT. */
fmb_status fmb_lock_equalities(fmb_pruner *p);
/* All inequalities that are always tight become equalities, or go. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_implicit_equalities(fmb_pruner *p);

#endif
