/* watch.c: see watch.h. A signal handler can reach only static storage, so what it needs stands
 * there. */
#include "validate/watch.h"

#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "common/signals.h"

enum { BAR = 40 };                  /* characters */
static const double interval = 0.2; /* between two updates [s] */

static study_validator *_Atomic running[VALIDATE_MOST_THREADS];
static atomic_bool asked_to_stop;
static atomic_uint_least64_t done;
static atomic_flag drawing = ATOMIC_FLAG_INIT;
static uint64_t all_pairs;
static bool terminal;
static double shown; /* when the bar was drawn last [s] */

static void cancel(int signal_number)
{
    (void)signal_number;
    atomic_store(&asked_to_stop, true);
    for (int i = 0; i < VALIDATE_MOST_THREADS; i++) {
        study_validator *s = atomic_load(&running[i]);
        if (s)
            study_validator_cancel(s);
    }
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void validate_watch_begin(bool quiet, uint64_t all)
{
    terminal = !quiet && isatty(STDERR_FILENO);
    all_pairs = all;
    atomic_store(&asked_to_stop, false);
    atomic_store(&done, 0);
    shown = now();
    app_signals_set(cancel);
}

void validate_watch_end(void)
{
    app_signals_set(SIG_DFL);
    if (terminal)
        fprintf(stderr, "\r%*s\r", BAR + 8, "");
    fflush(stderr);
}

void validate_watch_set(int thread, study_validator *s)
{
    atomic_store(&running[thread], s);
}

static void draw(uint64_t part) /* thousandths */
{
    char bar[BAR + 1];
    for (unsigned i = 0; i < BAR; i++)
        bar[i] = i * 1000 < part * BAR ? '#' : '.';
    bar[BAR] = '\0';
    fprintf(stderr, "\r[%s] %3u %%", bar, (unsigned)(part / 10));
    fflush(stderr);
}

void validate_watch_step(uint64_t pairs)
{
    uint64_t so_far = atomic_fetch_add(&done, pairs) + pairs;
    if (!terminal || atomic_flag_test_and_set(&drawing))
        return;
    if (now() - shown > interval) {
        draw(so_far * 1000 / all_pairs);
        shown = now();
    }
    atomic_flag_clear(&drawing);
}

bool validate_watch_interrupted(void)
{
    return atomic_load(&asked_to_stop);
}
