/* stop.c: see stop.h. A signal handler can reach only static storage.
 *
 * Solvers and pairs are freed by their own thread, and the handler may run in another: so a thread
 * that removes one waits until no running handler could have seen it. The handler never waits. */
#include "fmb/stop.h"

#include <errno.h>
#include <signal.h>
#include <stdatomic.h>

#include "common/signals.h"

typedef struct running {
    fmb_solver *_Atomic solver;
    fmb_pair *_Atomic pairs;
    fmb_frame_reader *_Atomic reader;
} running;

static running of_thread[APP_MOST_THREADS];
static _Thread_local int this_thread;
static atomic_bool asked_to_stop;
static atomic_int handlers_at_work;

static void cancel(int signal_number)
{
    int before = errno; /* of the call that the signal came in */
    (void)signal_number;
    asked_to_stop = true;
    atomic_fetch_add(&handlers_at_work, 1);
    for (int i = 0; i < APP_MOST_THREADS; i++) {
        fmb_solver_cancel(of_thread[i].solver);
        fmb_pair_cancel(of_thread[i].pairs);
        fmb_frame_reader_cancel(of_thread[i].reader);
    }
    atomic_fetch_sub(&handlers_at_work, 1);
    errno = before;
}

static void wait_for_handlers(void)
{
    while (atomic_load(&handlers_at_work) > 0)
        ;
}

/* A signal that arrived before a query began is passed on at the first event of the query.
 */
static void put(void *self, const fmb_event *e)
{
    (void)e;
    if (asked_to_stop)
        fmb_solver_cancel(self);
}

void app_stop_begin(fmb_solver *solver)
{
    asked_to_stop = false;
    app_stop_join(0, solver);
    app_signals_set(cancel);
}

void app_stop_end(void)
{
    app_signals_set(SIG_DFL);
    app_stop_leave();
}

void app_stop_join(int number, fmb_solver *solver)
{
    this_thread = number;
    fmb_solver_set_sink(solver, (fmb_sink){put, solver});
    of_thread[number].solver = solver;
}

void app_stop_leave(void)
{
    of_thread[this_thread].solver = NULL;
    of_thread[this_thread].pairs = NULL;
    of_thread[this_thread].reader = NULL;
    wait_for_handlers();
}

void app_stop_pairs(fmb_pair *k)
{
    of_thread[this_thread].pairs = k;
    wait_for_handlers();
}

void app_stop_reader(fmb_frame_reader *lines)
{
    of_thread[this_thread].reader = lines;
    wait_for_handlers();
}

bool app_stop_asked(void)
{
    return asked_to_stop;
}
