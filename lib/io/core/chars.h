/* chars.h: what a byte of a text is, whatever the locale. */
#ifndef FMB_IO_CHARS_H
#define FMB_IO_CHARS_H

#include <stdbool.h>

static inline bool fmb_is_digit(int b)
{
    return b >= '0' && b <= '9';
}

/* Value of a hexadecimal digit, or -1. */
static inline int fmb_hex_value(int b)
{
    int letter = b | 32;
    return fmb_is_digit(b) ? b - '0' : letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

/* Can a number with a sign begin so? */
static inline bool fmb_starts_number(int b)
{
    return fmb_is_digit(b) || b == '+' || b == '-' || b == '.';
}

#endif
