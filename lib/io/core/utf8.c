/* utf8.c: characters of a text; see fmb/io.h. */
#include <fmb/io.h>

size_t fmb_utf8_length(const char *text, size_t left)
{
    const unsigned char *p = (const unsigned char *)text;
    if (!text || left == 0)
        return 0;
    if (p[0] < 0x80)
        return 1;
    if (p[0] < 0xC2 || p[0] > 0xF4)
        return 0;
    size_t n = p[0] < 0xE0 ? 2 : p[0] < 0xF0 ? 3 : 4;
    if (left < n)
        return 0;
    for (size_t i = 1; i < n; i++)
        if ((p[i] & 0xC0) != 0x80)
            return 0;
    bool bad = (p[0] == 0xE0 && p[1] < 0xA0) || (p[0] == 0xED && p[1] > 0x9F) ||
               (p[0] == 0xF0 && p[1] < 0x90) || (p[0] == 0xF4 && p[1] > 0x8F);
    return bad ? 0 : n;
}

size_t fmb_utf8_printable(const char *text, size_t left)
{
    const unsigned char *p = (const unsigned char *)text;
    size_t n = fmb_utf8_length(text, left);
    bool control = n == 1 ? p[0] < 32 || p[0] == 127 : n == 2 && p[0] == 0xC2 && p[1] < 0xA0;
    return control ? 0 : n;
}
