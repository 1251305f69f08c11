/* signals.h: the signals of Ctrl-C, kill, a closed terminal, and a limit of processor time. */
#ifndef APP_SIGNALS_H
#define APP_SIGNALS_H

#include <signal.h>

/* SIGINT, SIGTERM, SIGHUP and SIGXCPU. */
void app_signals_fill(sigset_t *set);

/* Set their handler. It is called once: a second signal ends the program, as does one with SIG_DFL.
 * System calls are restarted after it. */
void app_signals_set(void (*handler)(int));

#endif
