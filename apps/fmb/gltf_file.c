/* gltf_file.c: see gltf_file.h. As glTF 2.0 has it (Khronos Group, 2021; ISO/IEC 12113:2022):
 * chapter 3.6 buffers and accessors, 4.4 GLB. Extensions that the file requires are refused, except
 * those that do not change positions, and integer positions (KHR_mesh_quantization).
 */
#include "fmb/gltf_file.h"

#include <libgen.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"

bool gltf_refuse(gltf *g, const char *format, ...)
{
    char text[256];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (g->code == APP_YES)
        g->code = app_error_at((app_place){.file = g->file->path}, APP_BAD_INPUT, "%s", text);
    return false;
}

/* ---- JSON ------------------------------------------------------------------------------------ */

bool gltf_whole(gltf *g, const json_t *of, const char *key, size_t usual, size_t *out)
{
    const json_t *value = json_object_get(of, key);
    *out = usual;
    if (!value)
        return true;
    if (!json_is_integer(value) || json_integer_value(value) < 0 ||
        json_integer_value(value) > UINT32_MAX)
        return gltf_refuse(g, "expected a whole number \"%s\" that is not negative", key);
    *out = (size_t)json_integer_value(value);
    return true;
}

const json_t *gltf_entry(gltf *g, const char *array, size_t at)
{
    const json_t *list = json_object_get(g->root, array), *entry = json_array_get(list, at);
    if (!json_is_object(entry))
        gltf_refuse(g, "expected one of %zu \"%s\", numbered from 0, found %zu",
                    json_array_size(list), array, at);
    return entry;
}

bool gltf_numbers(gltf *g, const json_t *of, const char *key, size_t n, double *out)
{
    const json_t *list = json_object_get(of, key);
    if (!list)
        return false;
    for (size_t i = 0; i < n; i++) {
        const json_t *x = json_array_get(list, i);
        if (!json_is_number(x) || json_array_size(list) != n)
            return gltf_refuse(g, "expected %zu numbers \"%s\" of a node", n, key);
        out[i] = json_number_value(x);
    }
    return true;
}

size_t gltf_node(gltf *g, const json_t *number)
{
    if (json_is_integer(number) && json_integer_value(number) >= 0)
        return (size_t)json_integer_value(number);
    gltf_refuse(g, "expected numbers of nodes in \"nodes\" and \"children\"");
    return SIZE_MAX;
}

/* ---- buffers --------------------------------------------------------------------------------- */

static int digit_of_base64(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)(at - digits) : -1;
}

/* [give, free() out->p] */
static bool read_base64(gltf *g, const char *text, scene_bytes *out)
{
    size_t length = strcspn(text, "="), bits = 0, kept = 0;
    out->p = app_need(malloc(length + 1));
    for (size_t i = 0; i < length; i++) {
        int digit = digit_of_base64(text[i]);
        if (digit < 0)
            return gltf_refuse(g, "expected base64 in the uri of a buffer, found '%c'", text[i]);
        kept = (kept << 6 | (size_t)digit) & 0xffff;
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            out->p[out->n++] = (unsigned char)(kept >> bits);
        }
    }
    return true;
}

/* "%20" is a blank. */
static void decode_percents(char *text)
{
    char *to = text;
    unsigned byte;
    for (; *text; to++)
        if (*text == '%' && sscanf(text + 1, "%2x", &byte) == 1 && text[1] && text[2]) {
            *to = (char)byte;
            text += 3;
        } else {
            *to = *text++;
        }
    *to = '\0';
}

/* [give, free() out->p] A file beside this one. */
static bool read_neighbour(gltf *g, const char *uri, scene_bytes *out)
{
    char *name = app_need(strdup(uri)), *place = app_need(strdup(g->file->path)), *path = NULL;
    decode_percents(name);
    if (asprintf(&path, "%s/%s", dirname(place), name) < 0)
        app_need(NULL);
    if (name[0] == '/' || strstr(name, "://"))
        gltf_refuse(g, "expected the name of a file beside this one in the uri of a buffer");
    if (g->code == APP_YES)
        g->code = scene_read_bytes(path, g->file->most, out);
    free(name);
    free(place);
    free(path);
    return g->code == APP_YES;
}

static bool read_buffer(gltf *g, size_t at)
{
    const json_t *of = gltf_entry(g, "buffers", at);
    const char *uri = of ? json_string_value(json_object_get(of, "uri")) : NULL;
    scene_bytes *b = &g->buffer[at];
    size_t length = 0;
    if (!of || !gltf_whole(g, of, "byteLength", 0, &length))
        return false;
    const char *data = uri && strncmp(uri, "data:", 5) == 0 ? strstr(uri, ";base64,") : NULL;
    if (data)
        read_base64(g, data + 8, b);
    else if (uri)
        read_neighbour(g, uri, b);
    else if (at == 0 && g->chunk.p)
        *b = (scene_bytes){memcpy(app_need(malloc(g->chunk.n + 1)), g->chunk.p, g->chunk.n),
                           g->chunk.n};
    else
        gltf_refuse(g, "expected a uri of buffer %zu", at);
    if (g->code == APP_YES && b->n < length)
        gltf_refuse(g, "expected %zu bytes in buffer %zu, found %zu", length, at, b->n);
    return g->code == APP_YES;
}

/* ---- accessors ------------------------------------------------------------------------------- */

enum { INT8 = 5120, UINT8, INT16, UINT16, UINT32 = 5125, REAL };

static size_t bytes_of_type(size_t type)
{
    static const size_t bytes[] = {1, 1, 2, 2, 0, 4, 4};
    return type >= INT8 && type <= REAL ? bytes[type - INT8] : 0;
}

bool gltf_accessor_take(gltf *g, size_t at, size_t width, gltf_accessor *out)
{
    const json_t *of = gltf_entry(g, "accessors", at), *view;
    size_t from, number, buffer, start, length;
    *out = (gltf_accessor){0};
    if (!of || !gltf_whole(g, of, "count", 0, &out->count) ||
        !gltf_whole(g, of, "componentType", 0, &out->type) ||
        !gltf_whole(g, of, "byteOffset", 0, &from) ||
        !gltf_whole(g, of, "bufferView", SIZE_MAX, &number))
        return false;
    const char *kind = json_string_value(json_object_get(of, "type"));
    size_t size = width * bytes_of_type(out->type);
    if (size == 0 || !kind || strcmp(kind, width == 3 ? "VEC3" : "SCALAR") != 0 ||
        json_object_get(of, "sparse") || number == SIZE_MAX)
        return gltf_refuse(g, "expected %s in accessor %zu, dense and in a buffer",
                           width == 3 ? "vectors of three numbers" : "numbers", at);
    out->normalized = json_is_true(json_object_get(of, "normalized"));
    view = gltf_entry(g, "bufferViews", number);
    if (!view || !gltf_whole(g, view, "buffer", SIZE_MAX, &buffer) ||
        !gltf_whole(g, view, "byteOffset", 0, &start) ||
        !gltf_whole(g, view, "byteLength", 0, &length) ||
        !gltf_whole(g, view, "byteStride", size, &out->stride))
        return false;
    if (buffer >= g->buffers || (!g->buffer[buffer].p && !read_buffer(g, buffer)))
        return gltf_refuse(g, "expected one of %zu buffers", g->buffers);
    const scene_bytes *b = &g->buffer[buffer];
    if (start > b->n || length > b->n - start || from > length || out->stride < size ||
        (out->count > 0 &&
         (size > length - from || (out->count - 1) > (length - from - size) / out->stride)))
        return gltf_refuse(g, "expected %zu entries of accessor %zu inside its buffer", out->count,
                           at);
    out->p = b->p + start + from;
    return true;
}

bool gltf_accessor_is_whole(const gltf_accessor *a)
{
    return a->type != REAL && !a->normalized;
}

double gltf_number(const gltf_accessor *a, size_t i, size_t k)
{
    const unsigned char *p = a->p + i * a->stride + k * bytes_of_type(a->type);
    uint32_t bits = 0;
    for (size_t j = bytes_of_type(a->type); j-- > 0;)
        bits = bits << 8 | p[j];
    float real;
    memcpy(&real, &bits, sizeof real);
    switch (a->type) {
    case INT8:
        return a->normalized ? fmax((int8_t)bits / 127.0, -1) : (int8_t)bits;
    case INT16:
        return a->normalized ? fmax((int16_t)bits / 32767.0, -1) : (int16_t)bits;
    case UINT8:
        return a->normalized ? bits / 255.0 : bits;
    case UINT16:
        return a->normalized ? bits / 65535.0 : bits;
    case UINT32:
        return bits;
    default:
        return (double)real;
    }
}

/* ---- files ----------------------------------------------------------------------------------- */

/* Does the extension leave positions unchanged? */
static bool may_be_ignored(const char *extension)
{
    return strncmp(extension, "KHR_materials_", 14) == 0 ||
           strncmp(extension, "KHR_texture_", 12) == 0 ||
           strcmp(extension, "KHR_lights_punctual") == 0 ||
           strcmp(extension, "EXT_texture_webp") == 0 ||
           strcmp(extension, "KHR_mesh_quantization") == 0;
}

static bool check_head(gltf *g)
{
    const char *version =
        json_string_value(json_object_get(json_object_get(g->root, "asset"), "version"));
    const json_t *needed;
    size_t i;
    if (!version || strncmp(version, "2.", 2) != 0)
        return gltf_refuse(g, "expected version 2 of glTF in \"asset\", found %s",
                           version ? version : "none");
    json_array_foreach(json_object_get(g->root, "extensionsRequired"), i, needed) if (
        !json_is_string(needed) ||
        !may_be_ignored(json_string_value(
            needed))) return gltf_refuse(g,
                                         "expected no extension that changes positions, found %s",
                                         json_is_string(needed) ? json_string_value(needed)
                                                                : "none");
    return true;
}

/* The least significant byte first. */
static uint32_t word_at(const char *text)
{
    uint32_t w = 0;
    for (int k = 3; k >= 0; k--)
        w = w << 8 | (unsigned char)text[k];
    return w;
}

/* Header of three words, chunks of two and what they hold: JSON, then perhaps BIN. */
static bool split_glb(gltf *g, const char **text, size_t *size)
{
    enum { HEADER = 12, HEAD_OF_CHUNK = 8, JSON = 0x4E4F534A, BIN = 0x004E4942 };
    const char *at = *text + HEADER, *end = *text + *size;
    if (*size < HEADER + HEAD_OF_CHUNK || word_at(*text + 4) != 2 || word_at(at + 4) != JSON ||
        word_at(at) > (size_t)(end - at) - HEAD_OF_CHUNK)
        return gltf_refuse(g, "expected GLB of version 2, with JSON first");
    *size = word_at(at);
    *text = at + HEAD_OF_CHUNK;
    at = *text + *size;
    if (end - at >= HEAD_OF_CHUNK && word_at(at + 4) == BIN &&
        word_at(at) <= (size_t)(end - at) - HEAD_OF_CHUNK)
        g->chunk = (scene_bytes){(unsigned char *)(uintptr_t)(at + HEAD_OF_CHUNK), word_at(at)};
    return true;
}

static bool read_root(gltf *g, const char *text, size_t size)
{
    json_error_t error;
    if (size >= 4 && memcmp(text, "glTF", 4) == 0 && !split_glb(g, &text, &size))
        return false;
    g->root = json_loadb(text, size, 0, &error);
    if (!g->root)
        g->code = app_error_at(
            (app_place){.file = g->file->path, .line = error.line, .column = error.column},
            APP_BAD_INPUT, "%s", error.text);
    return g->root != NULL;
}

bool gltf_open(gltf *g, const scene_file *file)
{
    g->file = file;
    if (!read_root(g, (const char *)file->all.p, file->all.n) || !check_head(g))
        return false;
    g->buffers = json_array_size(json_object_get(g->root, "buffers"));
    g->buffer = app_need(calloc(g->buffers + 1, sizeof *g->buffer));
    return true;
}

void gltf_close(gltf *g)
{
    for (size_t i = 0; i < g->buffers; i++)
        free(g->buffer[i].p);
    free(g->buffer);
    json_decref(g->root);
}
