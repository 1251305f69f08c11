/* listen.h: input that may arrive slowly. */
#ifndef APP_LISTEN_H
#define APP_LISTEN_H

#include <stdio.h>

typedef struct app_listener {
    FILE *in;                 /* nothing was read from it yet */
    void (*idle)(void *self); /* called before waiting */
    void *self;
    char room[1 << 16]; /* of the stream */
} app_listener;

/* [give, fclose()] A stream of the input, for use between app_stop_begin and app_stop_end: it ends
 * at a signal, too, even in the middle of a line. It borrows l. NULL without memory. */
FILE *app_listen(app_listener *l);

#endif
