/* threemf.c: the triangles of a 3MF file: see scene.h; a module. A zip, by libzip, of a model in
 * XML, by expat (3MF Core Specification 1.3: chapter 4 objects, 3.3 what is built, 3.2
 * transformations). Lengths are as they stand there, whatever the unit. Extensions are passed over;
 * one that puts objects into other files (production) is refused.
 */
#include <expat.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "fmb/threemf_module.h"

static const scene_host *host;

/* ---- a model on its way ---------------------------------------------------------------------- */

/* x' = x M: rows of three, the last one of which is added. */
typedef struct place {
    double m[4][3];
} place;

/* Something of an object, or of what is built, at its place. */
typedef struct component {
    uint32_t object;
    place at;
} component;

/* With triangles of its own, or made of others. */
typedef struct object {
    uint32_t id;
    char *name;
    double (*point)[3];
    uint32_t (*triangle)[3];
    component *part;
    size_t points, point_room, triangles, triangle_room, parts, part_room;
} object;

typedef struct model {
    const scene_file *file;
    XML_Parser parser;
    object *list, built; /* built: what is to be */
    size_t objects, room;
    FILE *obj;
    size_t vertices, placed; /* written; objects at a place */
    int code;
} model;

/* Report the first error, with its place in the XML; it ends the reading. */
__attribute__((format(printf, 2, 3))) static bool refuse(model *m, const char *format, ...)
{
    char text[256];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (m->code == APP_YES)
        m->code = host->error_at(
            (app_place){m->file->path, m->parser ? (long)XML_GetCurrentLineNumber(m->parser) : 0,
                        m->parser ? (long)XML_GetCurrentColumnNumber(m->parser) + 1 : 0},
            APP_BAD_INPUT, "%s", text);
    if (m->parser)
        XML_StopParser(m->parser, XML_FALSE);
    return false;
}

/* [borrow] Room for one more at the end of a list. */
static void *append(void **list, size_t *size, size_t *room, size_t bytes)
{
    if (*size == *room) {
        *room = 2 * *room + 16;
        *list = host->need(realloc(*list, *room * bytes));
    }
    return memset((char *)*list + (*size)++ * bytes, 0, bytes);
}

/* ---- attributes ------------------------------------------------------------------------------ */

static const char *find_attribute(const XML_Char **list, const char *name)
{
    while (list[0] && strcmp(list[0], name) != 0)
        list += 2;
    return list[0] ? list[1] : NULL;
}

static bool take_number(model *m, const XML_Char **list, const char *name, double *out)
{
    const char *text = find_attribute(list, name);
    char *end = NULL;
    *out = text ? strtod(text, &end) : NAN;
    return (text && end != text && !*end && isfinite(*out)) ||
           refuse(m, "expected a number \"%s\"", name);
}

static bool take_whole(model *m, const XML_Char **list, const char *name, uint32_t *out)
{
    const char *text = find_attribute(list, name);
    char *end = NULL;
    unsigned long long x = text && *text >= '0' && *text <= '9' ? strtoull(text, &end, 10) : 0;
    *out = (uint32_t)x;
    return (end && end != text && !*end && x <= UINT32_MAX) ||
           refuse(m, "expected a whole number \"%s\"", name);
}

/* Twelve numbers, row by row; without any everything stays where it is. */
static bool take_place(model *m, const XML_Char **list, place *out)
{
    const char *text = find_attribute(list, "transform");
    *out = (place){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
    for (int i = 0; text && i < 12; i++) {
        char *end;
        double x = strtod(text, &end);
        if (end == text || !isfinite(x))
            return refuse(m, "expected 12 numbers in \"transform\"");
        out->m[i / 3][i % 3] = x;
        text = end;
    }
    return true;
}

/* ---- elements -------------------------------------------------------------------------------- */

static object *last_object(model *m)
{
    if (m->objects == 0)
        refuse(m, "expected an object around this");
    return m->objects > 0 ? &m->list[m->objects - 1] : NULL;
}

static void begin_object(model *m, const XML_Char **list)
{
    object *o = append((void **)&m->list, &m->objects, &m->room, sizeof *o);
    const char *name = find_attribute(list, "name");
    if (take_whole(m, list, "id", &o->id) && name)
        o->name = host->need(strdup(name));
}

static void begin_vertex(model *m, const XML_Char **list)
{
    object *o = last_object(m);
    if (!o)
        return;
    double *p = append((void **)&o->point, &o->points, &o->point_room, sizeof *o->point);
    if (take_number(m, list, "x", &p[0]) && take_number(m, list, "y", &p[1]))
        take_number(m, list, "z", &p[2]);
}

static void begin_triangle(model *m, const XML_Char **list)
{
    object *o = last_object(m);
    if (!o)
        return;
    uint32_t *v =
        append((void **)&o->triangle, &o->triangles, &o->triangle_room, sizeof *o->triangle);
    static const char *const corner[] = {"v1", "v2", "v3"};
    for (int k = 0; k < 3; k++)
        if (take_whole(m, list, corner[k], &v[k]) && v[k] >= o->points)
            refuse(m, "expected one of %zu vertices, numbered from 0, found %u", o->points, v[k]);
}

static void begin_component(model *m, const XML_Char **list, object *o)
{
    component *c;
    if (find_attribute(list, "p:path")) {
        refuse(m, "expected objects of this file alone, found one of another");
    } else if (o) {
        c = append((void **)&o->part, &o->parts, &o->part_room, sizeof *c);
        if (take_whole(m, list, "objectid", &c->object))
            take_place(m, list, &c->at);
    }
}

static void XMLCALL begin_element(void *self, const XML_Char *name, const XML_Char **list)
{
    model *m = self;
    if (m->code != APP_YES)
        return;
    if (strcmp(name, "object") == 0)
        begin_object(m, list);
    else if (strcmp(name, "vertex") == 0)
        begin_vertex(m, list);
    else if (strcmp(name, "triangle") == 0)
        begin_triangle(m, list);
    else if (strcmp(name, "component") == 0)
        begin_component(m, list, last_object(m));
    else if (strcmp(name, "item") == 0)
        begin_component(m, list, &m->built);
}

/* What begins an entity could go on without end. */
static void XMLCALL begin_document_type(void *self, const XML_Char *name, const XML_Char *system,
                                        const XML_Char *public, int internal)
{
    (void)name, (void)system, (void)public, (void)internal;
    refuse(self, "expected no document type");
}

static bool parse_model(model *m, const scene_bytes *xml)
{
    size_t done = 0;
    m->parser = host->need(XML_ParserCreate(NULL));
    XML_SetUserData(m->parser, m);
    XML_SetStartElementHandler(m->parser, begin_element);
    XML_SetStartDoctypeDeclHandler(m->parser, begin_document_type);
    for (bool last = false; m->code == APP_YES && !last;) {
        size_t more = xml->n - done < 1 << 20 ? xml->n - done : 1 << 20;
        last = done + more == xml->n;
        if (XML_Parse(m->parser, (const char *)xml->p + done, (int)more, last) == XML_STATUS_ERROR)
            refuse(m, "%s", XML_ErrorString(XML_GetErrorCode(m->parser)));
        done += more;
    }
    XML_ParserFree(m->parser);
    m->parser = NULL;
    return m->code == APP_YES;
}

/* ---- what is built --------------------------------------------------------------------------- */

static const object *find_object(model *m, uint32_t id)
{
    size_t i = 0;
    while (i < m->objects && m->list[i].id != id)
        i++;
    if (i == m->objects)
        refuse(m, "expected an object with the id %u", id);
    return i < m->objects ? &m->list[i] : NULL;
}

/* First `inner`, then `outer`. */
static place join_places(const place *inner, const place *outer)
{
    place out;
    for (int r = 0; r < 4; r++)
        for (int c = 0; c < 3; c++) {
            out.m[r][c] = r == 3 ? outer->m[3][c] : 0;
            for (int k = 0; k < 3; k++)
                out.m[r][c] += inner->m[r][k] * outer->m[k][c];
        }
    return out;
}

static bool write_points(model *m, const object *o, const place *at)
{
    for (size_t i = 0; i < o->points; i++) {
        double y[3];
        for (int c = 0; c < 3; c++) {
            y[c] = at->m[3][c];
            for (int k = 0; k < 3; k++)
                y[c] += o->point[i][k] * at->m[k][c];
            if (!isfinite(y[c]))
                return refuse(m, "expected coordinates that stay finite");
        }
        fprintf(m->obj, "v %.17g %.17g %.17g\n", y[0], y[1], y[2]);
    }
    return true;
}

static bool write_mesh(model *m, const object *o, const place *at)
{
    char number[32];
    snprintf(number, sizeof number, "object %u", o->id);
    host->write_name(m->obj, o->name && *o->name ? o->name : number);
    if (!write_points(m, o, at))
        return false;
    for (size_t i = 0; i < o->triangles; i++)
        fprintf(m->obj, "f %zu %zu %zu\n", m->vertices + o->triangle[i][0] + 1,
                m->vertices + o->triangle[i][1] + 1, m->vertices + o->triangle[i][2] + 1);
    m->vertices += o->points;
    return (size_t)ftell(m->obj) <= m->file->most ||
           refuse(m, "expected at most %zu bytes once all objects are at their places",
                  m->file->most);
}

/* left: the remaining depth of nesting, as no object may contain itself. */
static bool write_object(model *m, const object *o, const place *at, size_t left)
{
    enum { MOST_PLACED = 1 << 20 }; /* as few objects may be made of many of each other */
    if (left == 0)
        return refuse(m, "expected objects that are not made of themselves");
    if (++m->placed > MOST_PLACED)
        return refuse(m, "expected at most %d objects at their places", MOST_PLACED);
    if (o->triangles > 0 && !write_mesh(m, o, at))
        return false;
    for (size_t i = 0; i < o->parts; i++) {
        const object *part = find_object(m, o->part[i].object);
        place joined = join_places(&o->part[i].at, at);
        if (!part || !write_object(m, part, &joined, left - 1))
            return false;
    }
    return true;
}

/* ---- the zip --------------------------------------------------------------------------------- */

/* The model, by its usual name or as the one file that ends like it. */
static zip_int64_t find_model(zip_t *z)
{
    zip_int64_t at = zip_name_locate(z, "3D/3dmodel.model", ZIP_FL_NOCASE);
    for (zip_int64_t i = 0; at < 0 && i < zip_get_num_entries(z, 0); i++) {
        const char *name = zip_get_name(z, (zip_uint64_t)i, 0),
                   *dot = name ? strrchr(name, '.') : NULL;
        if (dot && strcmp(dot, ".model") == 0)
            at = i;
    }
    return at;
}

/* [give, free() out->p] At most so many bytes once it is unpacked, whatever it says of itself. */
static bool unpack_entry(model *m, zip_t *z, zip_int64_t at, scene_bytes *out)
{
    zip_file_t *f = at >= 0 ? zip_fopen_index(z, (zip_uint64_t)at, 0) : NULL;
    zip_int64_t more = 1;
    if (!f)
        return refuse(m, "expected a model, 3D/3dmodel.model, in the zip");
    while (more > 0 && out->n <= m->file->most) {
        size_t room = out->n + out->n / 2 + 65536;
        out->p = host->need(realloc(out->p, room));
        more = zip_fread(f, out->p + out->n, room - out->n);
        out->n += more > 0 ? (size_t)more : 0;
    }
    zip_fclose(f);
    if (more < 0)
        return refuse(m, "expected a model that can be unpacked");
    return out->n <= m->file->most ||
           refuse(m, "expected a model of at most %zu bytes (--max-input)", m->file->most);
}

static bool unpack_model(model *m, scene_bytes *out)
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t *source = zip_source_buffer_create(m->file->all.p, m->file->all.n, 0, &error);
    zip_t *z = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : NULL;
    bool good = z ? unpack_entry(m, z, find_model(z), out)
                  : refuse(m, "expected a zip: %s", zip_error_strerror(&error));
    if (z)
        zip_discard(z);
    else
        zip_source_free(source);
    zip_error_fini(&error);
    return good;
}

static void forget_object(object *o)
{
    free(o->name);
    free(o->point);
    free(o->triangle);
    free(o->part);
}

static int write_as_obj(const scene_host *program, const scene_file *in, FILE *obj)
{
    static const place here = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
    model m = {.file = in, .obj = obj};
    scene_bytes xml = {NULL, 0};
    host = program;
    if (unpack_model(&m, &xml) && parse_model(&m, &xml))
        write_object(&m, &m.built, &here, m.objects + 2);
    for (size_t i = 0; i < m.objects; i++)
        forget_object(&m.list[i]);
    forget_object(&m.built);
    free(m.list);
    free(xml.p);
    return m.code;
}

const scene_3mf_module scene_3mf = {write_as_obj};
