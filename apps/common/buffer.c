/* buffer.c: see buffer.h. */
#include "common/buffer.h"

#include <stdlib.h>
#include <string.h>

#include "common/need.h"

char *app_buffer_reserve(app_buffer *b, size_t more)
{
    if (more >= b->room - b->size) {
        b->room = 2 * (b->size + more) + 62;
        b->text = app_need(realloc(b->text, b->room));
    }
    return b->text + b->size;
}

void app_buffer_put(app_buffer *b, const char *text)
{
    size_t n = strlen(text);
    memcpy(app_buffer_reserve(b, n), text, n + 1);
    b->size += n;
}
