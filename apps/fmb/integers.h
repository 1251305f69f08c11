/* integers.h: the meaning of an answer over the reals if the file has integer variables. Infeasible
 * stays infeasible, and a bound or a redundant row holds; only "feasible" may be wrong.
 */
#ifndef APP_INTEGERS_H
#define APP_INTEGERS_H

#include "fmb/query.h"

/* For commands whose answer is over the reals: say so once, unless --relax or --quiet. */
void app_integers_note(app_session *s);
void app_integers_note_of(app_session *s, const fmb_system *file);
/* After fmb_solve: is the point of a feasible system integral in its integer variables? If not, and
 * without --relax, it is replaced by a solution with the nearest integers, if there is one; else
 * the session is relaxed. An exit code, APP_YES if there was no error. */
int app_integers_seek(app_session *s);
/* After fmb_optimize: does the answer hold for the integers, too? An outer end does. Else the
 * session is relaxed unless the optimum, which may be NULL, is attained by a point that is integral
 * in the integer variables; or the form is unbounded and there is such a point (adding some
 * multiple of the ray, which is rational, gives further ones). */
void app_integers_judge(app_session *s, const fmb_optimum *o);

#endif
