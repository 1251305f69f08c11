/* memory_stream.h: memory as a stream, for functions that only take streams. The stream's own few
 * bytes come from the C library. */
#ifndef FMB_BASE_MEMORY_STREAM_H
#define FMB_BASE_MEMORY_STREAM_H

#include <fmb/base.h>

/* A stream that reads `size` bytes of text, which must outlive it; the caller closes it. NULL: out
 * of memory. */
FILE *fmb_memory_stream(const char *text, size_t size);

/* A function that writes an object to a stream, like the functions *_write of the API. */
typedef fmb_status fmb_writes_fn(const void *self, FILE *out);

/* Write an object to memory, like the functions *_print of the API: *length = the number of bytes;
 * they and a NUL go to text[size] only if they fit. Errors: ARG (length NULL, or text NULL and size
 * not 0), MEMORY, and those of writing. */
fmb_status fmb_memory_print(fmb_writes_fn *writes, const void *self, char *text, size_t size,
                            size_t *length);

#endif
