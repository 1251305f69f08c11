/* memory_stream.c: see memory_stream.h. */
#include "base/memory_stream.h"

#include <stdlib.h>
#include <string.h>

FILE *fmb_memory_stream(const char *text, size_t size)
{
    /* POSIX allows a stream of 0 bytes to fail: use one of a single byte, and read that byte. */
    static const char none[] = " ";
    FILE *in = fmemopen((void *)(uintptr_t)(size > 0 ? text : none), size > 0 ? size : 1, "rb");
    if (in && size == 0)
        getc(in);
    return in;
}

fmb_status fmb_memory_print(fmb_writes_fn *writes, const void *self, char *text, size_t size,
                            size_t *length)
{
    char *bytes = NULL;
    size_t n = 0;
    if (!length || (!text && size > 0))
        return FMB_ERR_ARG;
    FILE *out = open_memstream(&bytes, &n);
    if (!out)
        return FMB_ERR_MEMORY;
    fmb_status st = writes(self, out);
    bool is_whole = fclose(out) == 0;
    if (st == FMB_ERR_IO || (st == FMB_OK && !is_whole)) /* its only lack is memory */
        st = FMB_ERR_MEMORY;
    if (st == FMB_OK && n < size)
        memcpy(text, bytes, n + 1);
    if (st == FMB_OK)
        *length = n;
    free(bytes);
    return st;
}
