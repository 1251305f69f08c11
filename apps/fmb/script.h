/* script.h: fmb solve of an SMT-LIB script that asks more than once. */
#ifndef APP_SCRIPT_H
#define APP_SCRIPT_H

#include <fmb/io.h>

#include "fmb/query.h"

/* Answer all that the script asks, whose solver is open, on standard output; source is how it was
 * read. The exit code: undecided if some check is, else that of the last check. */
int app_script_answer(app_session *s, fmb_script *script, const char *file);

#endif
