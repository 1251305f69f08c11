/* message.h: what a command says on standard error. */
#ifndef APP_MESSAGE_H
#define APP_MESSAGE_H

#include <fmb/base.h>

#include "common/exit_code.h"
#include "common/need.h"

/* "PROGRAM: TEXT", with control characters escaped, as names of files may hold any; returns code,
 * so that a caller may write `return app_error(APP_USAGE, ...)`. */
int app_error(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Say why a call of the library failed; the exit code that goes with it. */
int app_status_error(fmb_status st);

#endif
