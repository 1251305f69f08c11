/* projection.h: reporting a projection. */
#ifndef APP_PROJECTION_H
#define APP_PROJECTION_H

#include "fmb/query.h"

/* Print it, as JSON or in that format; the exit code. NULL: what is known is that there are limits.
 */
int app_projection_report(const app_session *s, const fmb_system *projection, fmb_format to);
/* The same of its classes (<fmb/symmetry.h>) under symmetries of what was projected on keep[n];
 * NULL: each row is one. */
int app_classes_report(const app_session *s, const fmb_system *projection,
                       const fmb_permutations *symmetries, const int *keep, int n);

#endif
