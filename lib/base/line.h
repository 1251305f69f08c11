/* line.h: lines of a stream, piece by piece. The programs compile this file, too. */
#ifndef FMB_BASE_LINE_H
#define FMB_BASE_LINE_H

#include <stdio.h>
#include <string.h>

/* Read at most n - 1 bytes, up to a line end, into to[n], n > 1; returns how many, 0 at the end of
 * the stream. fgets does not return that number, which matters if bytes are NUL: so the buffer is
 * filled with line ends first, which shows where fgets put its own NUL. */
static inline size_t fmb_fetch_part_of_line(FILE *in, char *to, size_t n)
{
    if (!to) /* gcc does not see that there is room, and warns with sanitizers */
        return 0;
    memset(to, '\n', n);
    if (!fgets(to, (int)n, in))
        return 0;
    const char *end = memchr(to, '\n', n);
    if (!end)
        return n - 1;
    size_t before = (size_t)(end - to);
    return before + 1 < n && end[1] == '\0' ? before + 1 : before - 1;
}

#endif
