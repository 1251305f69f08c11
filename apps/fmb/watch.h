/* watch.h: what happens beside a running query: Ctrl-C, the trace, progress on a terminal. */
#ifndef APP_WATCH_H
#define APP_WATCH_H

#include <fmb/solve.h>

typedef struct app_watch {
    fmb_solver *solver;
    fmb_sink trace; /* {NULL, NULL} if there is none */
    bool terminal;  /* may progress be shown? */
    double shown;   /* when it was shown last [s] */
    int width;      /* characters on the line now */
    uint64_t lps, rows;
    int round;
} app_watch;

/* From here to app_watch_end SIGINT and its like (signals.h) cancel the solver's query; a second
 * one ends the process. One watch at a time. */
void app_watch_begin(app_watch *w, fmb_solver *solver, fmb_sink trace, bool quiet);
void app_watch_end(app_watch *w);

#endif
