/* script.h: fmb solve for an SMT-LIB script with several questions. */
#ifndef APP_SCRIPT_H
#define APP_SCRIPT_H

#include <fmb/io.h>

#include "fmb/query.h"

/* Answer all questions of the script from `file` on standard output; the solver of s is open. The
 * exit code: undecided if some check is, else that of the last check. */
int app_script_answer(app_session *s, fmb_script *script, const char *file);

#endif
