/* gltf.c: the triangles of a glTF file: see scene.h. As glTF 2.0 has it: chapter 3.5 scenes, nodes
 * and transformations, 3.7 primitives.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb/gltf_file.h"

/* ---- triangles ------------------------------------------------------------------------------- */

enum { TRIANGLES = 4, STRIP, FAN };

/* Write points at their place in the scene, computed in doubles. */
static bool write_points(gltf *g, const double m[16], const gltf_accessor *points)
{
    for (size_t i = 0; i < points->count; i++) {
        double x[3], y[3];
        for (size_t k = 0; k < 3; k++)
            x[k] = gltf_number(points, i, k);
        for (int r = 0; r < 3; r++)
            y[r] = m[r] * x[0] + m[4 + r] * x[1] + m[8 + r] * x[2] + m[12 + r];
        if (!isfinite(y[0]) || !isfinite(y[1]) || !isfinite(y[2]))
            return gltf_refuse(g, "expected finite positions");
        fprintf(g->obj, "v %.17g %.17g %.17g\n", y[0], y[1], y[2]);
    }
    return true;
}

/* The corners of triangle i among `count` vertices in the order of the mode (3.7.2.1). */
static void corners_of_triangle(size_t mode, size_t i, size_t corner[3])
{
    size_t turned = i & 1;
    if (mode == TRIANGLES)
        memcpy(corner, (size_t[3]){3 * i, 3 * i + 1, 3 * i + 2}, 3 * sizeof *corner);
    else if (mode == STRIP)
        memcpy(corner, (size_t[3]){i, i + 1 + turned, i + 2 - turned}, 3 * sizeof *corner);
    else
        memcpy(corner, (size_t[3]){0, i + 1, i + 2}, 3 * sizeof *corner);
}

static bool write_triangles(gltf *g, size_t mode, const gltf_accessor *points,
                            const gltf_accessor *indices)
{
    size_t count = indices ? indices->count : points->count;
    size_t triangles = mode == TRIANGLES ? count / 3 : count < 3 ? 0 : count - 2;
    for (size_t i = 0; i < triangles; i++) {
        size_t corner[3];
        corners_of_triangle(mode, i, corner);
        for (int k = 0; k < 3; k++) {
            if (indices)
                corner[k] = (size_t)gltf_number(indices, corner[k], 0);
            if (corner[k] >= points->count)
                return gltf_refuse(g, "expected one of %zu positions, numbered from 0, found %zu",
                                   points->count, corner[k]);
        }
        fprintf(g->obj, "f %zu %zu %zu\n", g->vertices + corner[0] + 1, g->vertices + corner[1] + 1,
                g->vertices + corner[2] + 1);
    }
    return true;
}

static bool write_primitive(gltf *g, const json_t *of, const double m[16])
{
    gltf_accessor points, indices;
    size_t mode, position, index;
    if (!gltf_whole(g, of, "mode", TRIANGLES, &mode) ||
        !gltf_whole(g, json_object_get(of, "attributes"), "POSITION", SIZE_MAX, &position) ||
        !gltf_whole(g, of, "indices", SIZE_MAX, &index))
        return false;
    if (mode < TRIANGLES || position == SIZE_MAX)
        return true; /* points and lines, or nothing that has a place */
    if (mode > FAN)
        return gltf_refuse(g, "expected a mode from 0 to 6, found %zu", mode);
    if (!gltf_accessor_take(g, position, 3, &points) ||
        (index != SIZE_MAX && !gltf_accessor_take(g, index, 1, &indices)))
        return false;
    if (index != SIZE_MAX && !gltf_accessor_is_whole(&indices))
        return gltf_refuse(g, "expected whole numbers in accessor %zu", index);
    bool good = write_points(g, m, &points) &&
                write_triangles(g, mode, &points, index != SIZE_MAX ? &indices : NULL);
    g->vertices += points.count;
    return good;
}

static const char *name_in(const json_t *of)
{
    const char *name = json_string_value(json_object_get(of, "name"));
    return name && *name ? name : NULL;
}

/* Write the name of the node, or of its mesh. */
static void write_name(const gltf *g, const json_t *node, const json_t *mesh)
{
    const char *own = name_in(node), *shared = name_in(mesh);
    scene_write_name(g->obj, own ? own : shared ? shared : "");
}

static bool write_mesh(gltf *g, const json_t *node, const double m[16])
{
    size_t at, i;
    const json_t *mesh, *primitive;
    if (!gltf_whole(g, node, "mesh", SIZE_MAX, &at) || at == SIZE_MAX)
        return g->code == APP_YES;
    mesh = gltf_entry(g, "meshes", at);
    if (!mesh)
        return false;
    write_name(g, node, mesh);
    json_array_foreach(json_object_get(mesh, "primitives"), i,
                       primitive) if (!write_primitive(g, primitive, m)) return false;
    return true;
}

/* ---- nodes ----------------------------------------------------------------------------------- */

/* out = a b; columns one after another. */
static void multiply(const double a[16], const double b[16], double out[16])
{
    for (int c = 0; c < 4; c++)
        for (int r = 0; r < 4; r++) {
            double sum = 0;
            for (int k = 0; k < 4; k++)
                sum += a[4 * k + r] * b[4 * c + k];
            out[4 * c + r] = sum;
        }
}

/* Translation, rotation by a unit quaternion (x, y, z, w), scale (3.5.3). */
static void matrix_of_parts(const double t[3], const double q[4], const double s[3], double out[16])
{
    double x = q[0], y = q[1], z = q[2], w = q[3];
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                               {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                               {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
    memset(out, 0, 16 * sizeof *out);
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < 3; r++)
            out[4 * c + r] = s[c] * turn[c][r];
    memcpy(out + 12, t, 3 * sizeof *t);
    out[15] = 1;
}

static void matrix_of_node(gltf *g, const json_t *node, double out[16])
{
    double t[3] = {0}, q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
    if (gltf_numbers(g, node, "matrix", 16, out))
        return;
    gltf_numbers(g, node, "translation", 3, t);
    gltf_numbers(g, node, "rotation", 4, q);
    gltf_numbers(g, node, "scale", 3, s);
    matrix_of_parts(t, q, s, out);
}

/* Write a node and its descendants; left: the remaining depth, as none may contain itself.
 */
static bool write_node(gltf *g, size_t at, const double above[16], size_t left)
{
    const json_t *node = gltf_entry(g, "nodes", at), *child;
    double own[16], m[16];
    size_t i;
    if (!node)
        return false;
    if (left == 0)
        return gltf_refuse(g, "expected nodes that are not children of themselves");
    matrix_of_node(g, node, own);
    multiply(above, own, m);
    if (g->code != APP_YES || !write_mesh(g, node, m))
        return false;
    json_array_foreach(json_object_get(node, "children"), i,
                       child) if (!write_node(g, gltf_node(g, child), m, left - 1)) return false;
    return true;
}

/* The roots, if the file has no scene: the nodes that are no children. */
static json_t *find_roots(const gltf *g)
{
    const json_t *nodes = json_object_get(g->root, "nodes"), *node, *child;
    size_t n = json_array_size(nodes), i, k;
    bool *is_child = app_need(calloc(n + 1, sizeof *is_child));
    json_t *roots = app_need(json_array());
    json_array_foreach(nodes, i, node)
        json_array_foreach(json_object_get(node, "children"), k,
                           child) if (json_is_integer(child) && json_integer_value(child) >= 0 &&
                                      (size_t)json_integer_value(child) < n)
            is_child[json_integer_value(child)] = true;
    for (i = 0; i < n; i++)
        if (!is_child[i])
            json_array_append_new(roots, json_integer((json_int_t)i));
    free(is_child);
    return roots;
}

/* Is each node a root or a child at most once? Shared children could multiply without bound. */
static bool is_forest(gltf *g)
{
    const json_t *node, *child;
    size_t i, k, children = 0;
    json_array_foreach(json_object_get(g->root, "nodes"), i, node) children +=
        json_array_size(json_object_get(node, "children"));
    json_t *seen = app_need(json_object());
    json_array_foreach(json_object_get(g->root, "nodes"), i, node)
        json_array_foreach(json_object_get(node, "children"), k, child)
    {
        char key[32];
        snprintf(key, sizeof key, "%" JSON_INTEGER_FORMAT, json_integer_value(child));
        json_object_set_new(seen, key, json_true());
    }
    bool good = json_object_size(seen) == children;
    json_decref(seen);
    return good || gltf_refuse(g, "expected each node to be a child of one node at most");
}

static bool write_scene(gltf *g)
{
    static const double one[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    size_t number, i;
    const json_t *root;
    if (!gltf_whole(g, g->root, "scene", 0, &number) || !is_forest(g))
        return false;
    const json_t *scene = json_array_get(json_object_get(g->root, "scenes"), number);
    json_t *roots = scene ? json_incref(json_object_get(scene, "nodes")) : find_roots(g);
    bool good = true;
    json_array_foreach(roots, i, root) good =
        good &&
        write_node(g, gltf_node(g, root), one, json_array_size(json_object_get(g->root, "nodes")));
    json_decref(roots);
    return good;
}

int scene_gltf_as_obj(const scene_file *in, FILE *obj)
{
    gltf g = {.obj = obj};
    if (gltf_open(&g, in))
        write_scene(&g);
    gltf_close(&g);
    return g.code;
}
