/* stop.c: see stop.h. A signal handler can reach only static storage. */
#include "fmb/stop.h"

#include <signal.h>

#include "common/signals.h"

static fmb_solver *volatile running;
static fmb_pair *volatile testing;
static fmb_frames *volatile reading;
static volatile sig_atomic_t asked_to_stop;

static void cancel(int signal_number)
{
    (void)signal_number;
    asked_to_stop = 1;
    if (running)
        fmb_solver_cancel(running);
    if (testing)
        fmb_pair_cancel(testing);
    if (reading)
        fmb_frames_cancel(reading);
}

/* A signal that came before a query began is passed on as soon as the query shows a sign of life.
 */
static void put(void *self, const fmb_event *e)
{
    (void)e;
    if (asked_to_stop)
        fmb_solver_cancel(self);
}

void app_stop_begin(fmb_solver *solver)
{
    asked_to_stop = 0;
    fmb_solver_set_sink(solver, (fmb_sink){put, solver});
    running = solver;
    app_signals_set(cancel);
}

void app_stop_end(void)
{
    app_signals_set(SIG_DFL);
    running = NULL;
    testing = NULL;
    reading = NULL;
}

void app_stop_pairs(fmb_pair *k)
{
    testing = k;
}

void app_stop_reader(fmb_frames *lines)
{
    reading = lines;
}

bool app_stop_asked(void)
{
    return asked_to_stop != 0;
}
