/* gltf_file.h: glTF 2.0: values in its JSON, and numbers in its buffers. A call that returns false
 * has reported an error, or there was one before.
 */
#ifndef APP_GLTF_FILE_H
#define APP_GLTF_FILE_H

#include <jansson.h>
#include <stdint.h>

#include "fmb/scene.h"

typedef struct gltf {
    const scene_file *file;
    json_t *root;
    scene_bytes *buffer; /* [buffers], those that are read */
    size_t buffers;
    scene_bytes chunk; /* BIN of a .glb, borrowed */
    FILE *obj;
    size_t vertices; /* written */
    int code;
} gltf;

/* [give, gltf_close] False unless it is of version 2 and requires no extension unknown here.
 */
bool gltf_open(gltf *g, const scene_file *file);
void gltf_close(gltf *g);

/* Report the first error, which ends the reading. */
bool gltf_refuse(gltf *g, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* ---- JSON ------------------------------------------------------------------------------------ */

/* A nonnegative integer; `usual` if there is none. */
bool gltf_whole(gltf *g, const json_t *of, const char *key, size_t usual, size_t *out);
/* n numbers. False, without a message, if there is no such key. */
bool gltf_numbers(gltf *g, const json_t *of, const char *key, size_t n, double *out);
/* Entry `at` of an array of the file, or NULL. */
const json_t *gltf_entry(gltf *g, const char *array, size_t at);
/* The number of a node in a list, or SIZE_MAX. */
size_t gltf_node(gltf *g, const json_t *number);

/* ---- accessors ------------------------------------------------------------------------------- */

/* An array of numbers in a buffer, perhaps interleaved with others. */
typedef struct gltf_accessor {
    const unsigned char *p;
    size_t count, stride, type;
    bool normalized;
} gltf_accessor;

/* Take accessor `at`, with `width` numbers per entry, 1 or 3. */
bool gltf_accessor_take(gltf *g, size_t at, size_t width, gltf_accessor *out);
bool gltf_accessor_is_whole(const gltf_accessor *a);
/* The k-th number of entry i; normalized integers are divided by the largest one. */
double gltf_number(const gltf_accessor *a, size_t i, size_t k);

#endif
