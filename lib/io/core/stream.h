/* stream.h: parsing a whole stream, or a whole text, at once. */
#ifndef FMB_IO_STREAM_H
#define FMB_IO_STREAM_H

#include <stdio.h>

#include "io/core/cursor.h"

/* Call parse with a cursor at the start of a text. Errors: ARG (text is NULL, or how is invalid),
 * PARSE (too long), and those of parse. */
typedef fmb_status fmb_parse_cursor_fn(fmb_cursor *c, void *self);
fmb_status fmb_parse_memory(const char *text, size_t size, const fmb_reader *how,
                            fmb_parse_cursor_fn *parse, void *self, fmb_where *where);

/* Like the function above, for all of a stream. Memory grows with the bytes read, whatever size the
 * stream claims. errno is that of reading. Errors: those above, IO, MEMORY. */
fmb_status fmb_parse_stream(FILE *in, const fmb_reader *how, fmb_parse_cursor_fn *parse, void *self,
                            fmb_where *where);

#endif
