/* signals.h: Ctrl-C and a polite kill. */
#ifndef APP_SIGNALS_H
#define APP_SIGNALS_H

/* What SIGINT and SIGTERM call. A handler is called once: a second signal ends the program, as one
 * does with SIG_DFL. Calls of the system go on after it. */
void app_signals_set(void (*handler)(int));

#endif
