/* stop.h: Ctrl-C for commands that ask many queries, one after the other. */
#ifndef APP_STOP_H
#define APP_STOP_H

#include <fmb/gmp.h>
#include <fmb/pair.h>
#include <fmb/solve.h>

/* From here to app_stop_end SIGINT and SIGTERM cancel what runs on the solver; a second one ends
 * the process. */
void app_stop_begin(fmb_solver *solver);
void app_stop_end(void);

/* Pairs that run on k are cancelled, too; NULL: none do. */
void app_stop_pairs(fmb_pair *k);

/* And so is a reader of frames. */
void app_stop_reader(fmb_frames *lines);

/* Did a signal come? */
bool app_stop_asked(void);

#endif
