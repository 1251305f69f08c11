/* shadow.h: reporting a projection. */
#ifndef APP_SHADOW_H
#define APP_SHADOW_H

#include "fmb/query.h"

/* Print it, as JSON or in that format; the exit code. NULL: what is known is that there are limits.
 */
int app_shadow_report(const app_session *s, const fmb_system *shadow, fmb_format to);
/* The same of its classes (<fmb/symmetry.h>) under symmetries of what was projected on keep[n];
 * NULL: each row is one. */
int app_classes_report(const app_session *s, const fmb_system *shadow,
                       const fmb_permutations *symmetries, const int *keep, int n);

#endif
