/* watch.c: see watch.h. A signal handler can reach only static storage, so the running solver is
 * kept there. Progress is shown by a separate thread: a single round of an elimination may take
 * minutes without events, while the time shown must advance. */
#include "fmb/watch.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <unistd.h>

#include "base/clock.h"
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

/* ---- the line on the terminal ---------------------------------------------------------------- */

/* Overwrites the line that is there, with spaces behind it if it was longer. */
static void show_progress(app_watch *w, double seconds)
{
    int width = fprintf(stderr, "\rfmb: ");
    if (w->round > 0)
        width += fprintf(stderr, "round %d, %llu rows, ", w->round, w->rows);
    if (w->lps > 0)
        width += fprintf(stderr, "%llu linear programs, ", w->lps);
    width += fprintf(stderr, "%.1f s", seconds);
    for (int i = width; i < w->width; i++)
        fputc(' ', stderr);
    fflush(stderr);
    w->width = width;
}

static void erase_progress(app_watch *w)
{
    if (w->width > 0)
        fprintf(stderr, "\r%*s\r", w->width, "");
    fflush(stderr);
    w->width = 0;
}

/* Waits until then [s], or the end. */
static void wait_until(app_watch *w, double then)
{
    const struct timespec at = {(time_t)then, (long)(1e9 * (then - floor(then)))};
    while (!w->over && fmb_monotonic_seconds() < then)
        pthread_cond_timedwait(&w->end, &w->lock, &at);
}

static void *show_until_the_end(void *self)
{
    app_watch *w = self;
    pthread_mutex_lock(&w->lock);
    for (double next = w->begun + patience; wait_until(w, next), !w->over;
         next = fmb_monotonic_seconds() + interval)
        show_progress(w, fmb_monotonic_seconds() - w->begun);
    pthread_mutex_unlock(&w->lock);
    return NULL;
}

/* Without a thread nothing is shown. */
static bool begin_to_show(app_watch *w)
{
    pthread_condattr_t monotonic;
    w->begun = fmb_monotonic_seconds();
    pthread_mutex_init(&w->lock, NULL);
    pthread_condattr_init(&monotonic);
    pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
    pthread_cond_init(&w->end, &monotonic);
    pthread_condattr_destroy(&monotonic);
    return pthread_create(&w->thread, NULL, show_until_the_end, w) == 0;
}

static void end_showing(app_watch *w)
{
    pthread_mutex_lock(&w->lock);
    w->over = true;
    pthread_cond_signal(&w->end);
    pthread_mutex_unlock(&w->lock);
    pthread_join(w->thread, NULL);
    erase_progress(w);
}

/* ---- the query ------------------------------------------------------------------------------- */

/* A signal that arrived before the query began does not cancel it by itself, but the user meant it:
 * it is passed on at the first event of the query. */
static void put(void *self, const fmb_event *e)
{
    app_watch *w = self;
    if (asked_to_stop)
        fmb_solver_cancel(w->solver);
    if (w->trace.put)
        w->trace.put(w->trace.self, e);
    if (e->kind == FMB_EVENT_ROUND) {
        w->rows = e->rows_out;
        w->round = e->round;
    }
    w->lps += e->kind == FMB_EVENT_LP;
}

void app_watch_begin(app_watch *w, fmb_solver *solver, fmb_sink trace, bool quiet)
{
    *w = (app_watch){.solver = solver, .trace = trace};
    w->shows = !quiet && isatty(STDERR_FILENO) && begin_to_show(w);
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
    if (w->shows)
        end_showing(w);
}
