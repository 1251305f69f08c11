/* stream.h: a whole stream at once. */
#ifndef FMB_IO_STREAM_H
#define FMB_IO_STREAM_H

#include <stdio.h>

#include "base/mem.h"

typedef struct fmb_bytes {
    char *p;
    size_t size, capacity;
} fmb_bytes;

/* All of a stream, or one byte more than most, behind what is there. Memory follows what has been
 * read, never what a stream claims to hold. Errors: IO, MEMORY. */
fmb_status fmb_read_whole_stream(FILE *in, size_t most, fmb_bytes *b, fmb_mem *mem);

#endif
