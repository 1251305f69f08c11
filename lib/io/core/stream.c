/* stream.c: see stream.h. */
#include "io/core/stream.h"

#include <errno.h>

typedef struct fmb_bytes {
    char *p;
    size_t size, capacity;
} fmb_bytes;

/* Append all of a stream to b, or the first most + 1 bytes of it. */
static fmb_status read_whole_stream(FILE *in, size_t most, fmb_bytes *b, fmb_mem *mem)
{
    while (b->size <= most) {
        FMB_TRY(FMB_RESERVE(mem, &b->p, &b->capacity, b->size + (1 << 14)));
        size_t n = fread(b->p + b->size, 1, b->capacity - b->size, in);
        b->size += n;
        if (n == 0)
            return ferror(in) ? FMB_ERR_IO : FMB_OK;
    }
    return FMB_OK;
}

fmb_status fmb_parse_memory(const char *text, size_t size, const fmb_reader *how,
                            fmb_parse_cursor_fn *parse, void *self, fmb_where *where)
{
    fmb_reader reader;
    fmb_where at = {0};
    fmb_mem mem;
    if (!text && size > 0)
        return fmb_io_refuse_argument(where, "text is NULL");
    FMB_TRY(fmb_io_take_reader(how, &reader, where));
    fmb_mem_init(&mem, reader.mem, 0);
    fmb_cursor c = fmb_io_cursor(text ? text : "", size, &reader, &mem, &at);
    fmb_status st =
        size > fmb_io_max_bytes(&reader) ? fmb_io_fail_too_long(&c, NULL) : parse(&c, self);
    if ((st == FMB_ERR_PARSE || st == FMB_ERR_ARG) && where)
        *where = at;
    return st;
}

fmb_status fmb_parse_stream(FILE *in, const fmb_reader *how, fmb_parse_cursor_fn *parse, void *self,
                            fmb_where *where)
{
    fmb_mem mem;
    fmb_bytes b = {0};
    fmb_reader reader;
    if (!in)
        return fmb_io_refuse_argument(where, "in is NULL");
    FMB_TRY(fmb_io_take_reader(how, &reader, where));
    fmb_mem_init(&mem, reader.mem, 0);
    fmb_status st = read_whole_stream(in, fmb_io_max_bytes(&reader), &b, &mem);
    int cause = errno;
    FMB_THEN(st, fmb_parse_memory(b.p, b.size, &reader, parse, self, where));
    fmb_mem_put(&mem, b.p, b.capacity, 1);
    if (st == FMB_ERR_IO)
        errno = cause;
    return st;
}
