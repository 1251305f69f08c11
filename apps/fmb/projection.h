/* projection.h: reporting a projection. */
#ifndef APP_PROJECTION_H
#define APP_PROJECTION_H

#include "fmb/query.h"

/* Print a projection, as JSON or in that format; the exit code. NULL: only the limit is reported.
 */
int app_projection_report(const app_session *s, const fmb_system *projection, fmb_format to);
/* Print its classes of rows (<fmb/symmetry.h>) under symmetries of the system, which was projected
 * on keep[n]; NULL: each row is a class. */
int app_classes_report(const app_session *s, const fmb_system *projection,
                       const fmb_permutations *symmetries, const int *keep, int n);

#endif
