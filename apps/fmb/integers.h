/* integers.h: what an answer over the reals says where the file has integer variables. Infeasible
 * stays infeasible, and a bound or a redundant row holds; only "feasible" may be wrong.
 */
#ifndef APP_INTEGERS_H
#define APP_INTEGERS_H

#include "fmb/query.h"

/* For commands whose answer is over the reals: say so once, unless --relax or --quiet. */
void app_integers_note(app_session *s);
void app_integers_note_of(app_session *s, const fmb_system *file);
/* After fmb_solve: is the point of a feasible system integral where it has to be? If not, and
 * without --relax, a point with the nearest integers takes its place if there is one; else the
 * session is relaxed. An exit code, APP_YES if all went well. */
int app_integers_seek(app_session *s);
/* After fmb_optimize: does the answer hold for the integers, too? An outer end does. Else the
 * session is relaxed unless the optimum, which may be NULL, is reached by a point that is integral
 * where it has to be; or, where the form is unbounded, there is such a point to begin with (some
 * multiple of the ray, which is rational, leads from one to the next). */
void app_integers_judge(app_session *s, const fmb_optimum *o);

#endif
