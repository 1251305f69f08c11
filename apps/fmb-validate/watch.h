/* watch.h: what happens beside a running validation: Ctrl-C, and a bar on a terminal. */
#ifndef VALIDATE_WATCH_H
#define VALIDATE_WATCH_H

#include "study/reference/validate.h"

enum { VALIDATE_MOST_THREADS = 256 };

/* From here to the end, SIGINT and SIGTERM cancel the validators at work; a second one ends the
 * process. One of several processes (common/ranks.h) ends at once: its counts are lost, and so is
 * the run. */
void validate_watch_begin(bool quiet, uint64_t all);
void validate_watch_end(void);

/* Thread number `thread` works with s from now on; NULL: with none. */
void validate_watch_set(int thread, study_validator *s);
/* So many more pairs are done; from any thread. */
void validate_watch_step(uint64_t pairs);
/* Did a signal end the run? */
bool validate_watch_interrupted(void);

#endif
