/* watch.h: the watcher of a running query: Ctrl-C, the trace, progress on a terminal. */
#ifndef APP_WATCH_H
#define APP_WATCH_H

#include <pthread.h>
#include <stdatomic.h>

#include <fmb/solve.h>

typedef struct app_watch {
    fmb_solver *solver;
    fmb_sink trace; /* {NULL, NULL} if there is none */
    atomic_int round;
    atomic_ullong rows, lps;
    bool shows; /* a thread shows progress on a terminal; the members below are for that */
    pthread_t thread;
    pthread_mutex_t lock; /* for `over` */
    pthread_cond_t end;
    bool over;
    double begun; /* [s] */
    int width;    /* characters on the line now */
} app_watch;

/* From here to app_watch_end SIGINT and similar signals (signals.h) cancel the solver's query; a
 * second one ends the process. One watch at a time; w must not be moved. */
void app_watch_begin(app_watch *w, fmb_solver *solver, fmb_sink trace, bool quiet);
void app_watch_end(app_watch *w);

#endif
