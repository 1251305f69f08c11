/* stop.h: Ctrl-C for commands that run many queries, one after another, perhaps by several threads.
 */
#ifndef APP_STOP_H
#define APP_STOP_H

#include <fmb/gmp.h>
#include <fmb/pair.h>
#include <fmb/solve.h>

enum { APP_MOST_THREADS = 64 };

/* From here to app_stop_end SIGINT and SIGTERM, which one thread receives, cancel the solver's
 * queries; a second one ends the process. */
void app_stop_begin(fmb_solver *solver);
void app_stop_end(void);

/* From here to app_stop_leave queries of this thread are cancelled, too; each thread has its own
 * number from 1 on, below APP_MOST_THREADS. */
void app_stop_join(int number, fmb_solver *solver);
void app_stop_leave(void);

/* Queries of k in this thread are cancelled, too; NULL: none are, and the former k may be freed.
 */
void app_stop_pairs(fmb_pair *k);

/* Cancel this reader of frames, too. */
void app_stop_reader(fmb_frame_reader *lines);

/* Has a signal arrived? */
bool app_stop_asked(void);

#endif
