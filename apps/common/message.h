/* message.h: what a command says on standard error. */
#ifndef APP_MESSAGE_H
#define APP_MESSAGE_H

#include <fmb/base.h>

#include "common/exit_code.h"

/* "PROGRAM: TEXT"; returns code, so that a caller may write `return app_error(APP_USAGE, ...)`. */
int app_error(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* "PROGRAM: FILE:LINE:COLUMN: TEXT", without the numbers that are 0; returns code. */
int app_error_at(int code, const char *file, const fmb_where *where);
void app_warning_at(const char *file, const fmb_where *where);

/* Say why a call of the library failed; the exit code that goes with it. */
int app_status_error(fmb_status st);

/* A pointer that must not be NULL: else says so and exits with APP_INTERNAL. */
void *app_need(void *p);

#endif
