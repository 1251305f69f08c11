/* line.h: lines of a stream, piece by piece. Programs see it, too: it compiles into them. */
#ifndef FMB_BASE_LINE_H
#define FMB_BASE_LINE_H

#include <stdio.h>
#include <string.h>

/* n > 1 bytes of room: at most n - 1 up to a line end are put there, and counted; 0 at the end of
 * the stream. fgets does not tell how many they are where some are NUL: it puts one behind the
 * last, and leaves line ends where it does not come. */
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
