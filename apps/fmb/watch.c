/* watch.c: see watch.h. A signal handler can reach only static storage, so the solver that is
 * running stands there. */
#include "fmb/watch.h"

#include <errno.h>
#include <signal.h>
#include <stdatomic.h>
#include <unistd.h>

#include "common/file.h"
#include "common/signals.h"

static fmb_solver *_Atomic running;
static atomic_bool asked_to_stop; /* perhaps in a thread of the library's */

static const double patience = 0.5;  /* before anything is shown [s] */
static const double interval = 0.15; /* between two updates [s] */

static void cancel(int signal_number)
{
    int before = errno;
    (void)signal_number;
    asked_to_stop = true;
    fmb_solver_cancel(running);
    errno = before;
}

/* Overwrites the line that is there, with spaces behind it if it was longer. */
static void show_progress(app_watch *w, double seconds)
{
    int width = fprintf(stderr, "\rfmb: round %d, %llu rows, %llu linear programs, %.1f s",
                        w->round, (unsigned long long)w->rows, (unsigned long long)w->lps, seconds);
    for (int i = width; i < w->width; i++)
        fputc(' ', stderr);
    fflush(stderr);
    w->width = width;
    w->shown = seconds;
}

static void erase_progress(app_watch *w)
{
    if (w->width > 0)
        fprintf(stderr, "\r%*s\r", w->width, "");
    fflush(stderr);
    w->width = 0;
}

/* A signal that came before the query began was not meant for it in the solver's eyes, but was in
 * the user's: it is passed on as soon as the query shows a sign of life. */
static void put(void *self, const fmb_event *e)
{
    app_watch *w = self;
    if (asked_to_stop)
        fmb_solver_cancel(w->solver);
    if (w->trace.put)
        w->trace.put(w->trace.self, e);
    if (e->kind == FMB_EVENT_ROUND) {
        w->round = e->round;
        w->rows = e->rows_out;
    }
    w->lps += e->kind == FMB_EVENT_LP;
    if (w->terminal && e->seconds > patience && e->seconds - w->shown > interval)
        show_progress(w, e->seconds);
}

void app_watch_begin(app_watch *w, fmb_solver *solver, fmb_sink trace, bool quiet)
{
    *w = (app_watch){.solver = solver, .trace = trace};
    w->terminal = !quiet && isatty(STDERR_FILENO);
    fmb_solver_set_sink(solver, (fmb_sink){put, w});
    asked_to_stop = false;
    running = solver;
    app_signals_set(cancel);
}

void app_watch_end(app_watch *w)
{
    app_signals_set(app_file_abandon);
    running = NULL;
    fmb_solver_set_sink(w->solver, (fmb_sink){NULL, NULL});
    erase_progress(w);
}
