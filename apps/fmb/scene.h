/* scene.h: files of scenes, glTF 2.0 (.gltf, .glb) and 3MF (.3mf), as text that the library reads:
 * the triangles of all objects at their places, each object a group with its name, as OBJ.
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

/* All of a file, and of what it names beside it, up to `most` bytes each. */
typedef struct scene_file {
    const char *path;
    size_t most;
    scene_bytes all;
} scene_file;

/* Exit codes of all of these, after messages. */

/* A whole file. */
int scene_read_bytes(const char *path, size_t most, scene_bytes *out);

typedef int scene_reader(const scene_file *in, FILE *obj);

/* Lines and points are left out, and skins and morph targets. */
scene_reader scene_gltf_as_obj;
/* What is to be built; objects are told by number where they have no name. */
scene_reader scene_3mf_as_obj;

/* "o NAME": a line, as OBJ has no quotes. */
void scene_write_name(FILE *obj, const char *name);

#endif
