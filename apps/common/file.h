/* file.h: opening and closing what a command reads and writes. "-" is standard input or output. */
#ifndef APP_FILE_H
#define APP_FILE_H

#include <stdio.h>

/* The name of an input in messages. */
const char *app_file_shown(const char *path);

/* [give, app_file_close_input] Open for reading: APP_YES or, with a message, APP_CANNOT_OPEN. A
 * folder cannot be opened. */
int app_file_open(const char *path, FILE **out);
/* Close what was read; standard input is left alone. */
void app_file_close_input(FILE *f);
/* [give, app_file_close] Open for writing: APP_YES or, with a message, APP_CANNOT_WRITE. */
int app_file_create(const char *path, FILE **out);
/* Close; NULL and the standard streams are left alone. APP_YES, or APP_CANNOT_WRITE with a message
 * if anything written to path was lost. */
int app_file_close(FILE *f, const char *path);

/* Have the exit of the process check standard output: what could not be written there turns the
 * exit code into APP_CANNOT_WRITE, whichever way the process ends. */
void app_file_guard_output(void);

#endif
