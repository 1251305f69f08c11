/* stream.h: a whole stream, or a whole text, at once. */
#ifndef FMB_IO_STREAM_H
#define FMB_IO_STREAM_H

#include <stdio.h>

#include "io/core/cursor.h"

/* Hand a text to a parser, at its beginning, with what that gets besides. Errors: ARG (no text, or
 * how is none), PARSE (too long), and the parser's. */
typedef fmb_status fmb_parse_cursor_fn(fmb_cursor *c, void *self);
fmb_status fmb_parse_memory(const char *text, size_t size, const fmb_reader *how,
                            fmb_parse_cursor_fn *parse, void *self, fmb_where *where);

/* The same of all of a stream. Memory follows what has been read, never what a stream claims to
 * hold. errno is that of reading. Errors: those above, IO, MEMORY. */
fmb_status fmb_parse_stream(FILE *in, const fmb_reader *how, fmb_parse_cursor_fn *parse, void *self,
                            fmb_where *where);

#endif
