/* peak.c: see peak.h. Linux: /proc/self, where writing 5 to clear_refs starts VmHWM anew (proc(5)).
 */
#include "peak.h"

#include <malloc.h>
#include <stdio.h>

/* A line "NAME   123 kB" of /proc/self/status. */
static size_t bytes_of(const char *name)
{
    FILE *in = fopen("/proc/self/status", "r");
    char line[256], format[64];
    size_t kilobytes = 0;
    if (!in)
        return 0;
    snprintf(format, sizeof format, "%s: %%zu kB", name);
    while (fgets(line, sizeof line, in) && sscanf(line, format, &kilobytes) != 1)
        ;
    fclose(in);
    return 1024 * kilobytes;
}

size_t peak_begin(void)
{
    malloc_trim(0);
    FILE *out = fopen("/proc/self/clear_refs", "w");
    if (out) {
        fputs("5", out);
        fclose(out);
    }
    return bytes_of("VmRSS");
}

size_t peak_end(size_t before)
{
    size_t most = bytes_of("VmHWM");
    return most > before ? most - before : 0;
}
