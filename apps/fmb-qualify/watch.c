/* watch.c: see watch.h. A signal handler can reach only static storage, so what it needs stands
 * there. */
#include "fmb-qualify/watch.h"

#include <signal.h>

#include "common/bar.h"
#include "common/file.h"
#include "common/ranks.h"
#include "common/signals.h"

static fmb_solver *volatile running;
static volatile sig_atomic_t asked_to_stop;
static app_bar bar;
static const char *shown_name = "";
static size_t part, parts;

static void cancel(int signal_number)
{
    (void)signal_number;
    asked_to_stop = 1;
    if (running)
        fmb_solver_cancel(running);
}

void qualify_watch_begin(bool quiet)
{
    bar = app_bar_begin(quiet);
    asked_to_stop = 0;
    app_signals_set(app_ranks() > 1 ? app_file_abandon : cancel);
}

void qualify_watch_name(const char *name)
{
    shown_name = name;
}

void qualify_watch_end(void)
{
    app_signals_set(SIG_DFL);
    running = NULL;
    app_bar_end(&bar);
}

fmb_solver *volatile *qualify_watch_solver(void)
{
    return &running;
}

bool qualify_watch_step(void *self, size_t done, size_t all)
{
    (void)self;
    app_bar_show(&bar, done, all, shown_name);
    return !asked_to_stop;
}

void qualify_watch_part(size_t done, size_t all)
{
    part = done;
    parts = all;
}

bool qualify_watch_step_within(void *self, size_t done, size_t all)
{
    enum { FINE = 1000 };
    return qualify_watch_step(self, part * FINE + done * FINE / all, parts * FINE);
}

bool qualify_watch_interrupted(void)
{
    return asked_to_stop != 0;
}
