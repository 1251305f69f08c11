/* signals.c: see signals.h. */
#include "common/signals.h"

#include <signal.h>
#include <stddef.h>

void app_signals_set(void (*handler)(int))
{
    struct sigaction act = {.sa_handler = handler};
    sigemptyset(&act.sa_mask);
    if (handler != SIG_DFL)
        act.sa_flags = (int)(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &act, NULL);
    sigaction(SIGTERM, &act, NULL);
}
