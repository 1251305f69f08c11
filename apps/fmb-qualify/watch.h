/* watch.h: what happens beside a running study: Ctrl-C, and a bar on a terminal. */
#ifndef QUALIFY_WATCH_H
#define QUALIFY_WATCH_H

#include <stdbool.h>
#include <stddef.h>

#include <fmb/solve.h>

/* From here to the end, SIGINT and SIGTERM cancel the query that runs and end the study; a second
 * one ends the process. Of several processes the first one ends all, and nothing is written. */
void qualify_watch_begin(bool quiet);
void qualify_watch_end(void);
/* What the bar is about; borrowed. */
void qualify_watch_name(const char *name);

/* Where the study notes the solver at work. */
fmb_solver *volatile *qualify_watch_solver(void);
/* Show how far it is; false after a signal. self is not used: it fits study_grid.step. */
bool qualify_watch_step(void *self, size_t done, size_t all);
/* The same for a part of a study: part number `done` of `all` begins; then how far it is. */
void qualify_watch_part(size_t done, size_t all);
bool qualify_watch_step_within(void *self, size_t done, size_t all);
/* Did a signal end the study? */
bool qualify_watch_interrupted(void);

#endif
