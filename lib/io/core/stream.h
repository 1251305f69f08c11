/* stream.h: a whole stream, or a whole text, at once. */
#ifndef FMB_IO_STREAM_H
#define FMB_IO_STREAM_H

#include <stdio.h>

#include "io/core/cursor.h"

typedef struct fmb_bytes {
    char *p;
    size_t size, capacity;
} fmb_bytes;

/* All of a stream, or one byte more than most, behind what is there. Memory follows what has been
 * read, never what a stream claims to hold. Errors: IO, MEMORY. */
fmb_status fmb_read_whole_stream(FILE *in, size_t most, fmb_bytes *b, fmb_mem *mem);

/* Hand a text to a parser, at its beginning, with what that gets besides. Errors: ARG (no text, or
 * how is none), PARSE (too long), and the parser's. */
typedef fmb_status fmb_parse_cursor_fn(fmb_cursor *c, void *self);
fmb_status fmb_parse_memory(const char *text, size_t size, const fmb_reader *how,
                            fmb_parse_cursor_fn *parse, void *self, fmb_where *where);

/* Hand all of a stream to a parser, with what that gets besides. errno is that of reading. Errors:
 * IO, MEMORY, ARG (in is NULL), and the parser's. */
typedef fmb_status fmb_parse_fn(const char *text, size_t size, const fmb_reader *how, void *self,
                                fmb_where *where);
fmb_status fmb_parse_stream(FILE *in, const fmb_reader *how, fmb_parse_fn *parse, void *self,
                            fmb_where *where);

#endif
