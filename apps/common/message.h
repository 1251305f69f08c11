/* message.h: what a command says on standard error. */
#ifndef APP_MESSAGE_H
#define APP_MESSAGE_H

#include <fmb/base.h>
#include <stdbool.h>

#include "common/exit_code.h"
#include "common/need.h"

/* Where a mistake is; what does not apply is NULL or 0. */
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
/* The same of what is no error. */
void app_warn_at(app_place at, const char *text);

/* From now on each error is one line of JSON: {"error": {"file", "line", "column", "text",
 * "exit"}}, with null for what does not apply. What ends with APP_UNDECIDED is an answer, told as
 * text. */
void app_errors_as_json(void);
bool app_errors_are_json(void);

/* What others write to stderr until the release is an error, too: its first line, without "NAME: ",
 * is told as one with APP_USAGE at the release or the exit. (argp and getopt do so.) */
void app_errors_capture(const char *name);
void app_errors_release(void);
/* The same, but what they wrote is forgotten; this asks for no memory. */
void app_errors_drop(void);

/* Say why a call of the library failed; the exit code that goes with it. */
int app_status_error(fmb_status st);

#endif
