/* signals.c: see signals.h. */
#include "common/signals.h"

#include <stdbool.h>
#include <stddef.h>

static const int CAUGHT[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};

enum { COUNT = sizeof CAUGHT / sizeof *CAUGHT };

void app_signals_fill(sigset_t *set)
{
    sigemptyset(set);
    for (int i = 0; i < COUNT; i++)
        sigaddset(set, CAUGHT[i]);
}

/* Is the signal ignored? nohup has a closed terminal ignored, a shell Ctrl-C in the background.
 */
static bool is_ignored(int number)
{
    struct sigaction now;
    return sigaction(number, NULL, &now) == 0 && now.sa_handler == SIG_IGN;
}

void app_signals_set(void (*handler)(int))
{
    struct sigaction act = {.sa_handler = handler};
    sigemptyset(&act.sa_mask);
    if (handler != SIG_DFL)
        act.sa_flags = (int)(SA_RESETHAND | SA_RESTART);
    for (int i = 0; i < COUNT; i++)
        if (!is_ignored(CAUGHT[i]))
            sigaction(CAUGHT[i], &act, NULL);
}
