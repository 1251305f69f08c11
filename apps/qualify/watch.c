/* watch.c: see watch.h. A signal handler can reach only static storage, so what it needs stands
 * there. */
#include "qualify/watch.h"

#include <signal.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "common/signals.h"

enum { BAR = 40 };                  /* characters */
static const double interval = 0.2; /* between two updates [s] */

static fmb_solver *volatile running;
static volatile sig_atomic_t asked_to_stop;
static bool terminal;
static const char *shown_name = "";
static size_t part, parts;
static double shown; /* when the bar was drawn last [s] */

static void cancel(int signal_number)
{
    (void)signal_number;
    asked_to_stop = 1;
    if (running)
        fmb_solver_cancel(running);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void qualify_watch_begin(bool quiet)
{
    terminal = !quiet && isatty(STDERR_FILENO);
    asked_to_stop = 0;
    shown = now();
    app_signals_set(cancel);
}

void qualify_watch_name(const char *name)
{
    shown_name = name;
}

void qualify_watch_end(void)
{
    app_signals_set(SIG_DFL);
    running = NULL;
    if (terminal)
        fprintf(stderr, "\r%*s\r", BAR + 24, "");
    fflush(stderr);
}

fmb_solver *volatile *qualify_watch_solver(void)
{
    return &running;
}

static void draw(size_t done, size_t all)
{
    char bar[BAR + 1];
    size_t permille = all > 0 ? done * 1000 / all : 1000;
    for (size_t i = 0; i < BAR; i++)
        bar[i] = i * 1000 < permille * BAR ? '#' : '.';
    bar[BAR] = '\0';
    fprintf(stderr, "\r[%s] %3zu %% %-8.12s", bar, permille / 10, shown_name);
    fflush(stderr);
}

bool qualify_watch_step(void *self, size_t done, size_t all)
{
    (void)self;
    double t = terminal ? now() : 0;
    if (terminal && t - shown > interval) {
        draw(done, all);
        shown = t;
    }
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
