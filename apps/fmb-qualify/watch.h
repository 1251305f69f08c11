/* watch.h: Ctrl-C and the progress bar of a running study. */
#ifndef QUALIFY_WATCH_H
#define QUALIFY_WATCH_H

#include <stdbool.h>
#include <stddef.h>

#include <fmb/solve.h>

/* From begin to end, SIGINT and SIGTERM cancel the running query and end the study; a second signal
 * ends the process. With several ranks the first signal ends all, and nothing is written. */
void qualify_watch_begin(bool quiet);
void qualify_watch_end(void);
/* The name that the bar shows; borrowed. */
void qualify_watch_name(const char *name);

/* Where the study stores the working solver, for cancels. */
fmb_solver *volatile *qualify_watch_solver(void);
/* Show the progress; false after a signal. self is not used: it fits study_grid.step. */
bool qualify_watch_step(void *self, size_t done, size_t all);
/* Likewise for a part of a study: part `done` of `all` begins; then the progress within it. */
void qualify_watch_part(size_t done, size_t all);
bool qualify_watch_step_within(void *self, size_t done, size_t all);
/* Did a signal end the study? */
bool qualify_watch_interrupted(void);

#endif
