/* stream.c: see stream.h. */
#include "io/core/stream.h"

fmb_status fmb_read_whole_stream(FILE *in, size_t most, fmb_bytes *b, fmb_mem *mem)
{
    while (b->size <= most) {
        fmb_status st = fmb_mem_reserve(mem, (void **)&b->p, &b->capacity, b->size + (1 << 14), 1);
        if (st != FMB_OK)
            return st;
        size_t n = fread(b->p + b->size, 1, b->capacity - b->size, in);
        b->size += n;
        if (n == 0)
            return ferror(in) ? FMB_ERR_IO : FMB_OK;
    }
    return FMB_OK;
}
