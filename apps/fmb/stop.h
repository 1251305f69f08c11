/* stop.h: Ctrl-C for commands that ask many queries, one after the other, perhaps by several
 * threads. */
#ifndef APP_STOP_H
#define APP_STOP_H

#include <fmb/gmp.h>
#include <fmb/pair.h>
#include <fmb/solve.h>

enum { APP_MOST_THREADS = 64 };

/* From here to app_stop_end SIGINT and SIGTERM, which one thread receives, cancel what runs on the
 * solver; a second one ends the process. */
void app_stop_begin(fmb_solver *solver);
void app_stop_end(void);

/* From here to app_stop_leave what this thread runs is cancelled, too; each has a number of its own
 * from 1 on, below APP_MOST_THREADS. */
void app_stop_join(int number, fmb_solver *solver);
void app_stop_leave(void);

/* Pairs that run on k in this thread are cancelled, too; NULL: none do, and the one before may be
 * freed. */
void app_stop_pairs(fmb_pair *k);

/* And so is a reader of frames. */
void app_stop_reader(fmb_frame_reader *lines);

/* Did a signal come? */
bool app_stop_asked(void);

#endif
