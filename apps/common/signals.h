/* signals.h: Ctrl-C, a polite kill, a terminal that is closed, processor time that is used up. */
#ifndef APP_SIGNALS_H
#define APP_SIGNALS_H

#include <signal.h>

/* SIGINT, SIGTERM, SIGHUP and SIGXCPU. */
void app_signals_fill(sigset_t *set);

/* What they call. A handler is called once: a second signal ends the program, as one
 * does with SIG_DFL. Calls of the system go on after it. */
void app_signals_set(void (*handler)(int));

#endif
