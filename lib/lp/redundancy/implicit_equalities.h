/* implicit_equalities.h: finds equalities that depend on others, and inequalities that hold with
 * equality at every solution.
 */
#ifndef FMB_LP_IMPLICIT_EQUALITIES_H
#define FMB_LP_IMPLICIT_EQUALITIES_H

#include "lp/redundancy/pruner.h"

/* Keep independent equalities, and remove those that depend on them. Errors: MEMORY, LIMIT. */
fmb_status fmb_lock_equalities(fmb_pruner *p);
/* Inequalities that are always tight become equalities, or are removed if these imply them.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_find_implicit_equalities(fmb_pruner *p);

#endif
