/* file.h: opening and closing what a command reads and writes. "-" is standard input or output.
 *
 * What is written to a file has no name until it is closed (a temporary one beside it where the
 * file system wants names), so nobody ever finds half an output under its name, nor loses the file
 * that was there before to a failure; and a process that is killed leaves nothing behind.
 * Devices and pipes are written to as they are. A file that is being read is not written to.
 */
#ifndef APP_FILE_H
#define APP_FILE_H

#include <stdio.h>

/* The name of an input in messages. */
const char *app_file_shown(const char *path);

/* [give, app_file_close_input] Open for reading: APP_YES or, with a message, APP_CANNOT_OPEN (a
 * folder cannot be opened), or APP_USAGE (standard output goes to that same file). */
int app_file_open(const char *path, FILE **out);
/* Close what was read; standard input is left alone. */
void app_file_close_input(FILE *f);

/* [give, app_file_close] Open for writing: APP_YES or, with a message, APP_CANNOT_WRITE, or
 * APP_USAGE for a file that this process reads or already writes. */
int app_file_create(const char *path, FILE **out);
/* Close and give it its name; NULL and the standard streams are left alone. APP_YES, or
 * APP_CANNOT_WRITE with a message if anything written to path was lost: then what was there before
 * stays. */
int app_file_close(FILE *f, const char *path);
/* Close, and forget what was written. An output that is never closed is forgotten, too, when the
 * process exits. */
void app_file_discard(FILE *f);

/* Have the exit of the process check standard output: what could not be written there turns the
 * exit code into APP_CANNOT_WRITE, whichever way the process ends. */
void app_file_guard_output(void);

/* A handler of signals: what has not got its name yet goes, and then the process. */
void app_file_abandon(int signal_number);

#endif
