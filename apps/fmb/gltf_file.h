/* gltf_file.h: glTF 2.0: what its JSON says, and numbers in its buffers. A call that returns false
 * has told a mistake, or there was one before.
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

/* [give, gltf_close] Is it of version 2, and does it do without extensions that are not known here?
 */
bool gltf_open(gltf *g, const scene_file *file);
void gltf_close(gltf *g);

/* The first mistake is told, and ends the reading. */
bool gltf_refuse(gltf *g, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* ---- JSON ------------------------------------------------------------------------------------ */

/* A whole number that is not negative; `usual` where there is none. */
bool gltf_whole(gltf *g, const json_t *of, const char *key, size_t usual, size_t *out);
/* n numbers. False, without a word, where there is no such key. */
bool gltf_numbers(gltf *g, const json_t *of, const char *key, size_t n, double *out);
/* Entry `at` of an array of the file, or NULL. */
const json_t *gltf_entry(gltf *g, const char *array, size_t at);
/* The number of a node in a list, or SIZE_MAX. */
size_t gltf_node(gltf *g, const json_t *number);

/* ---- accessors ------------------------------------------------------------------------------- */

/* Numbers in a row of structures. */
typedef struct gltf_accessor {
    const unsigned char *p;
    size_t count, stride, type;
    bool normalized;
} gltf_accessor;

/* `width` numbers an entry, 1 or 3. */
bool gltf_accessor_take(gltf *g, size_t at, size_t width, gltf_accessor *out);
bool gltf_accessor_is_whole(const gltf_accessor *a);
/* The k-th number of entry i; integers that are normalized are shares of the largest. */
double gltf_number(const gltf_accessor *a, size_t i, size_t k);

#endif
