/* utf8.h: characters of more than one byte. */
#ifndef FMB_IO_UTF8_H
#define FMB_IO_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/* Length of the UTF-8 character of more than one byte at s, 0 if there is none. Shortest forms
 * only, no surrogates, at most U+10FFFF: Unicode Standard 15, table 3-7. */
static inline size_t fmb_utf8_length(const char *s, size_t left)
{
    const unsigned char *p = (const unsigned char *)s;
    if (left < 2 || p[0] < 0xC2 || p[0] > 0xF4)
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

/* Bytes of the character at s that can stand in a text: not a control byte, not broken; else 0. */
static inline size_t fmb_utf8_printable(const char *s, size_t left)
{
    unsigned char b = left > 0 ? (unsigned char)*s : 0;
    return b < 32 || b == 127 ? 0 : b < 128 ? 1 : fmb_utf8_length(s, left);
}

#endif
