/* text.c: see text.h. */
#include "common/text.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/io.h>

#include "common/need.h"
#include "io/core/utf8.h"

static bool is_hex_digit(char byte)
{
    return (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'f');
}

/* What would be taken for an escape: then different names would look the same. */
static bool is_escape(const char *p)
{
    return p[0] == '\\' && p[1] == 'x' && is_hex_digit(p[2]) && is_hex_digit(p[3]);
}

/* Is the byte written unchanged, for a terminal and for JSON? */
static bool is_plain(char byte)
{
    return byte >= ' ' && byte <= '~' && byte != '\\';
}

void app_text_put(app_buffer *b, const char *raw, app_text_use use)
{
    size_t left = strlen(raw);
    char *text = app_buffer_reserve(b, 4 * left), *out = text;
    while (left > 0) {
        if (is_plain(*raw)) {
            *out++ = *raw++;
            left--;
            continue;
        }
        size_t bytes = (use == APP_TEXT_JSON ? fmb_utf8_length : fmb_utf8_printable)(raw, left);
        if (is_escape(raw))
            bytes = 0;
        if (bytes == 0)
            out += sprintf(out, "\\x%02x", (unsigned char)*raw);
        memcpy(out, raw, bytes);
        out += bytes;
        raw += bytes + (bytes == 0);
        left -= bytes + (bytes == 0);
    }
    *out = '\0';
    b->size += (size_t)(out - text);
}

char *app_text(const char *raw, app_text_use use)
{
    app_buffer b = {0};
    app_text_put(&b, raw, use);
    return b.text;
}

size_t app_text_width(const char *text)
{
    size_t width = 0, bytes = strlen(text);
    for (size_t i = 0; i < bytes; i++)
        width += ((unsigned char)text[i] & 0xC0) != 0x80;
    return width;
}
