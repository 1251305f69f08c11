/* text.h: names and labels made safe for output. Readers pass on any bytes of a file; a terminal
 * must not obey them, and JSON must be valid UTF-8. */
#ifndef APP_TEXT_H
#define APP_TEXT_H

#include "common/buffer.h"

typedef enum app_text_use {
    APP_TEXT_TERMINAL, /* control characters are escaped too */
    APP_TEXT_JSON      /* JSON has its own escapes for them */
} app_text_use;

/* Append raw as valid UTF-8: invalid bytes are written \xHH, and so is the backslash of a name that
 * contains such an escape: different names stay different. */
void app_text_put(app_buffer *b, const char *raw, app_text_use use);
/* [give, free()] raw made safe, as a text of its own. */
char *app_text(const char *raw, app_text_use use);

/* Characters of a valid UTF-8 text: its width in a table (wide characters count as one). */
size_t app_text_width(const char *text);

#endif
