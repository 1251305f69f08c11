/* text.c: see text.h. Source of the byte ranges: Unicode Standard, table 3-7 (well-formed UTF-8).
 */
#include "common/text.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"

static bool continues(unsigned char byte)
{
    return (byte & 0xC0) == 0x80;
}

/* Bytes of the well-formed character at p, 0 if there is none; p ends in NUL, which never
 * continues a character, so no byte behind it is read. */
static size_t character(const unsigned char *p)
{
    if (p[0] < 0x80)
        return 1;
    if (p[0] < 0xC2 || p[0] > 0xF4 || !continues(p[1]))
        return 0;
    if (p[0] < 0xE0)
        return 2;
    bool overlong = (p[0] == 0xE0 && p[1] < 0xA0) || (p[0] == 0xF0 && p[1] < 0x90);
    bool surrogate = p[0] == 0xED && p[1] > 0x9F;
    bool beyond = p[0] == 0xF4 && p[1] > 0x8F;
    if (overlong || surrogate || beyond || !continues(p[2]))
        return 0;
    if (p[0] < 0xF0)
        return 3;
    return continues(p[3]) ? 4 : 0;
}

/* C0, DEL, and C1 (U+0080 to U+009F), which some terminals obey as well. */
static bool is_control(const unsigned char *p)
{
    return p[0] < 0x20 || p[0] == 0x7F || (p[0] == 0xC2 && p[1] < 0xA0);
}

static bool is_hex_digit(unsigned char byte)
{
    return (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'f');
}

/* What would be taken for an escape: then different names would look the same. */
static bool is_escape(const unsigned char *p)
{
    return p[0] == '\\' && p[1] == 'x' && is_hex_digit(p[2]) && is_hex_digit(p[3]);
}

char *app_text(const char *raw, app_text_use use)
{
    const unsigned char *p = (const unsigned char *)raw;
    char *text = app_need(malloc(4 * strlen(raw) + 1));
    char *out = text;
    while (*p) {
        size_t bytes = character(p);
        if (bytes == 0 || is_escape(p) || (use == APP_TEXT_TERMINAL && is_control(p))) {
            out += sprintf(out, "\\x%02x", *p++);
            continue;
        }
        memcpy(out, p, bytes);
        out += bytes;
        p += bytes;
    }
    *out = '\0';
    return text;
}

size_t app_text_width(const char *text)
{
    size_t width = 0;
    for (; *text; text++)
        width += !continues((unsigned char)*text);
    return width;
}
