/* buffer.h: a text that grows. */
#ifndef APP_BUFFER_H
#define APP_BUFFER_H

#include <stddef.h>

/* Zero-initialise. text, from malloc, ends with a NUL once anything was put there. */
typedef struct app_buffer {
    char *text;
    size_t size, room;
} app_buffer;

/* Returns a place for `more` bytes and a NUL; the caller adds the bytes written to size. */
char *app_buffer_reserve(app_buffer *b, size_t more);
void app_buffer_put(app_buffer *b, const char *text);

#endif
