/* message.h: the messages of a command on standard error. */
#ifndef APP_MESSAGE_H
#define APP_MESSAGE_H

#include <fmb/base.h>
#include <stdbool.h>

#include "common/exit_code.h"
#include "common/need.h"

/* The place of an error; members that do not apply are NULL or 0. */
typedef struct app_place {
    const char *file;
    long line, column; /* from 1; a column without a file is one of an option's text */
} app_place;

/* "PROGRAM: TEXT", with control characters escaped, as names of files may hold any; returns code,
 * so that a caller may write `return app_error(APP_USAGE, ...)`. */
int app_error(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* "PROGRAM: FILE:LINE:COLUMN: TEXT", without the numbers that are 0. */
int app_error_at(app_place at, int code, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Like app_error_at, for a warning. */
void app_warn_at(app_place at, const char *text);

/* From now on each error is one line of JSON: {"error": {"file", "line", "column", "text",
 * "exit"}}, with null for members that do not apply. Messages with APP_UNDECIDED are no errors and
 * stay text. */
void app_errors_as_json(void);
bool app_errors_are_json(void);

/* Capture what libraries (argp, getopt) write to stderr until the release: the first line, without
 * "NAME: ", is reported as an error with APP_USAGE at the release or the exit. */
void app_errors_capture(const char *name);
void app_errors_release(void);
/* Release, and discard what they wrote; this allocates no memory. */
void app_errors_drop(void);

/* Report why a call of the library failed; returns the corresponding exit code. */
int app_status_error(fmb_status st);

#endif
