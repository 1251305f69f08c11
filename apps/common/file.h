/* file.h: opening and closing files of a command. "-" is standard input or output.
 *
 * An output file gets its name only when it is closed (until then it has a temporary one if the
 * file system needs names), so there is never half an output under its name, a failure does not
 * destroy an older file, and a process that is killed leaves nothing behind. Devices and pipes are
 * written directly. A file that is being read is not written to.
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
/* Close a file and give it its name; NULL and the standard streams are left alone. APP_YES, or
 * APP_CANNOT_WRITE with a message if anything written was lost: then an older file at path is kept.
 */
int app_file_close(FILE *f, const char *path);
/* Close, and discard the output. An output that is never closed is discarded, too, when the process
 * exits. */
void app_file_discard(FILE *f);

/* Check standard output when the process exits: if anything could not be written there, the exit
 * code becomes APP_CANNOT_WRITE, however the process ends. */
void app_file_guard_output(void);

/* A signal handler: remove unfinished outputs, then end the process. */
void app_file_abandon(int signal_number);

#endif
