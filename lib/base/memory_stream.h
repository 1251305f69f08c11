/* memory_stream.h: streams over memory, for what knows streams alone. Their few bytes come from the
 * C library. */
#ifndef FMB_BASE_MEMORY_STREAM_H
#define FMB_BASE_MEMORY_STREAM_H

#include <fmb/base.h>

/* A stream to read size bytes of text from, which it borrows; the caller closes it. NULL: there is
 * no memory. */
FILE *fmb_memory_stream(const char *text, size_t size);

/* Something writes itself to a stream, as the functions *_write of the API do. */
typedef fmb_status fmb_writes_fn(const void *self, FILE *out);

/* The same to memory, as the functions *_print do: *length bytes are written, a NUL behind them,
 * into text[size] if there is that much room, else nowhere. Errors: ARG (length NULL, or text NULL
 * and size not 0), MEMORY, and those of writing. */
fmb_status fmb_memory_print(fmb_writes_fn *writes, const void *self, char *text, size_t size,
                            size_t *length);

#endif
