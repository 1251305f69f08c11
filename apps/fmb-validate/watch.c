/* watch.c: see watch.h. A signal handler can reach only static storage, so what it needs stands
 * there. */
#include "fmb-validate/watch.h"

#include <signal.h>
#include <stdatomic.h>

#include "common/bar.h"
#include "common/file.h"
#include "common/ranks.h"
#include "common/signals.h"

static study_validator *_Atomic running[VALIDATE_MOST_THREADS];
static atomic_bool asked_to_stop;
static atomic_uint_least64_t done;
static atomic_flag drawing = ATOMIC_FLAG_INIT;
static uint64_t all_pairs;
static app_bar bar;

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

void validate_watch_begin(bool quiet, uint64_t all)
{
    bar = app_bar_begin(quiet || app_rank() > 0);
    all_pairs = all;
    atomic_store(&asked_to_stop, false);
    atomic_store(&done, 0);
    app_signals_set(app_ranks() > 1 ? app_file_abandon : cancel);
}

void validate_watch_end(void)
{
    if (app_ranks() == 1)
        app_signals_set(SIG_DFL);
    app_bar_end(&bar);
}

void validate_watch_set(int thread, study_validator *s)
{
    atomic_store(&running[thread], s);
}

void validate_watch_step(uint64_t pairs)
{
    uint64_t so_far = atomic_fetch_add(&done, pairs) + pairs;
    if (!bar.wanted || atomic_flag_test_and_set(&drawing))
        return;
    app_bar_show(&bar, so_far, all_pairs, NULL);
    atomic_flag_clear(&drawing);
}

bool validate_watch_interrupted(void)
{
    return atomic_load(&asked_to_stop);
}
