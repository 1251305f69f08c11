/* quote.c: texts in quotes; see number.h. */
#include "io/core/number.h"

#include <string.h>

#include "io/core/cursor.h"
#include "io/core/utf8.h"

/* One byte of a quoted text, after a backslash. */
static fmb_status scan_name_escape(fmb_cursor *c, char *out)
{
    const char *p = c->at - 1;
    int b = fmb_peek(c);
    if (b == '"' || b == '\\') {
        *out = *c->at++;
        return FMB_OK;
    }
    if (b == 'x' && c->end - c->at >= 3) {
        int high = fmb_hex_value(c->at[1]), low = fmb_hex_value(c->at[2]);
        if (high >= 0 && low >= 0 && high + low > 0) {
            c->at += 3;
            *out = (char)(unsigned char)(16 * high + low);
            return FMB_OK;
        }
    }
    return fmb_io_fail(c, p, "expected \\\", \\\\ or \\x and two hexadecimal digits, not both 0");
}

fmb_status fmb_scan_quoted(fmb_cursor *c, fmb_room *room, fmb_span *out)
{
    const char *start = c->at++;
    size_t n = 0;
    for (;;) {
        int b = fmb_peek(c);
        if (b < 0 || b == '\n')
            return fmb_io_fail(c, start, "expected a closing quote on the same line");
        c->at++;
        if (b == '"')
            break;
        FMB_TRY(FMB_RESERVE(c->mem, &room->p, &room->capacity, n + 1));
        char byte = (char)(unsigned char)b;
        if (b == '\\')
            FMB_TRY(scan_name_escape(c, &byte));
        room->p[n++] = byte;
    }
    *out = (fmb_span){n > 0 ? room->p : start, n};
    return FMB_OK;
}

void fmb_print_quoted(const char *text, FILE *out)
{
    fputc('"', out);
    for (size_t left = strlen(text); left > 0;) {
        size_t n = fmb_utf8_printable(text, left);
        if (n == 0)
            fprintf(out, "\\x%02x", (unsigned char)*text);
        else if (*text == '"' || *text == '\\')
            fprintf(out, "\\%c", *text);
        else
            fwrite(text, 1, n, out);
        text += n > 0 ? n : 1;
        left -= n > 0 ? n : 1;
    }
    fputc('"', out);
}
