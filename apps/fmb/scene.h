/* scene.h: files of scenes, glTF 2.0 (.gltf, .glb) and 3MF (.3mf), converted to OBJ text for the
 * library: the triangles of all placed objects, each object a group with its name.
 */
#ifndef APP_SCENE_H
#define APP_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct scene_bytes {
    unsigned char *p; /* [give, free()] */
    size_t n;
} scene_bytes;

/* A whole file; it and each file that it refers to have at most `most` bytes. */
typedef struct scene_file {
    const char *path;
    size_t most;
    scene_bytes all;
} scene_file;

/* Exit codes of all of these, after messages. */

/* A whole file. */
int scene_read_bytes(const char *path, size_t most, scene_bytes *out);

typedef int scene_reader(const scene_file *in, FILE *obj);

/* Lines, points, skins and morph targets are ignored. */
scene_reader scene_gltf_as_obj;
/* The items of the build; objects without a name are named by number. */
scene_reader scene_3mf_as_obj;

/* "o NAME": a line, as OBJ has no quotes. */
void scene_write_name(FILE *obj, const char *name);

#endif
