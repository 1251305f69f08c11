/* mesh_read.c: meshes from a stream or from memory: the part common to all formats. */
#include <string.h>

#include "io/core/stream.h"
#include "io/mesh/mesh_draft.h"

/* ---- the table ------------------------------------------------------------------------------- */

static bool starts_with_word(const fmb_cursor *from, const char *word)
{
    fmb_cursor c = *from;
    fmb_mesh_skip_comments(&c);
    return fmb_span_is_nocase(fmb_scan_word(&c), word);
}

static bool looks_like_off(const fmb_cursor *c)
{
    return starts_with_word(c, "OFF") || starts_with_word(c, "COFF") || starts_with_word(c, "NOFF");
}

static bool looks_like_ply(const fmb_cursor *c)
{
    return starts_with_word(c, "ply");
}

static bool looks_like_medit(const fmb_cursor *c)
{
    return starts_with_word(c, "MeshVersionFormatted");
}

static bool looks_like_stl(const fmb_cursor *c)
{
    return starts_with_word(c, "solid") || fmb_mesh_is_binary_stl(c);
}

typedef struct mesh_codec {
    fmb_mesh_format format;
    const char *name; /* its ending */
    bool is_text;     /* if not, the reader checks the bytes itself */
    fmb_mesh_read_fn *read;
    bool (*sniff)(const fmb_cursor *c); /* NULL: used if nothing else fits */
} mesh_codec;

static const mesh_codec codecs[] = {
    {FMB_MESH_PLY, "ply", false, fmb_mesh_read_ply, looks_like_ply},
    {FMB_MESH_OFF, "off", true, fmb_mesh_read_off, looks_like_off},
    {FMB_MESH_MEDIT, "mesh", true, fmb_mesh_read_medit, looks_like_medit},
    {FMB_MESH_STL, "stl", false, fmb_mesh_read_stl, looks_like_stl},
    {FMB_MESH_OBJ, "obj", true, fmb_mesh_read_obj, NULL},
};

enum { CODECS = sizeof codecs / sizeof *codecs };

static const mesh_codec *find_mesh_codec(fmb_mesh_format f)
{
    for (int i = 0; i < CODECS; i++)
        if (codecs[i].format == f)
            return &codecs[i];
    return NULL;
}

static const mesh_codec *guess_mesh_codec(const fmb_cursor *c)
{
    int i = 0;
    while (codecs[i].sniff && !codecs[i].sniff(c))
        i++;
    return &codecs[i];
}

const char *fmb_mesh_format_text(fmb_mesh_format f)
{
    const mesh_codec *codec = find_mesh_codec(f);
    return codec ? codec->name : "auto";
}

static const mesh_codec *find_codec_of_word(fmb_span word)
{
    for (int i = 0; i < CODECS; i++)
        if (fmb_span_is_nocase(word, codecs[i].name))
            return &codecs[i];
    return NULL;
}

bool fmb_mesh_format_parse(const char *word, fmb_mesh_format *out)
{
    if (!word || !out)
        return false;
    const mesh_codec *codec = find_codec_of_word((fmb_span){word, strlen(word)});
    if (!codec && strcmp(word, "auto") != 0)
        return false;
    *out = codec ? codec->format : FMB_MESH_AUTO;
    return true;
}

fmb_mesh_format fmb_mesh_format_of_name(const char *path)
{
    const char *dot = path ? strrchr(path, '.') : NULL;
    if (!dot || strchr(dot, '/'))
        return FMB_MESH_AUTO;
    const mesh_codec *codec = find_codec_of_word((fmb_span){dot + 1, strlen(dot + 1)});
    return codec ? codec->format : FMB_MESH_AUTO;
}

/* ---- parsing --------------------------------------------------------------------------------- */

/* Make a mesh of the tetrahedra, if there are any: then triangles are only their surface. */
static fmb_status make_mesh_of_draft(fmb_cursor *c, const fmb_mesh_draft *d, fmb_mesh **out)
{
    const fmb_alloc *hook = c->how->mem;
    const fmb_mesh_origin none = {0}, origin = {d->face, d->group, d->names, d->names_size};
    if (d->tetrahedra > 0)
        return fmb_mesh_new_of_file(4, d->points, d->point, d->tetrahedra, d->tetrahedron, &none,
                                    hook, out);
    if (d->triangles == 0)
        return fmb_io_fail(c, NULL, "expected triangles or tetrahedra, found none");
    return fmb_mesh_new_of_file(3, d->points, d->point, d->triangles, d->triangle, &origin, hook,
                                out);
}

typedef struct mesh_as {
    fmb_mesh_format format;
    fmb_mesh **out;
} mesh_as;

static fmb_status parse_mesh(fmb_cursor *c, void *self)
{
    const mesh_as *m = self;
    fmb_mesh_draft d = {.mem = c->mem, .skip = fmb_skip_space};
    const mesh_codec *codec =
        m->format == FMB_MESH_AUTO ? guess_mesh_codec(c) : find_mesh_codec(m->format);
    fmb_status st = codec->is_text ? fmb_io_check(c) : FMB_OK;
    FMB_THEN(st, codec->read(c, &d));
    FMB_THEN(st, make_mesh_of_draft(c, &d, m->out));
    fmb_mesh_draft_clear(&d);
    return st;
}

static fmb_status check_mesh_arguments(fmb_mesh_format f, fmb_mesh **out, fmb_where *where)
{
    if (!out)
        return fmb_io_refuse_argument(where, "out is NULL");
    return f == FMB_MESH_AUTO || find_mesh_codec(f)
               ? FMB_OK
               : fmb_io_refuse_argument(where, "f is no fmb_mesh_format");
}

fmb_status fmb_mesh_parse(const char *text, size_t size, fmb_mesh_format f, const fmb_reader *how,
                          fmb_mesh **out, fmb_where *where)
{
    FMB_TRY(check_mesh_arguments(f, out, where));
    return fmb_parse_memory(text, size, how, parse_mesh, &(mesh_as){f, out}, where);
}

fmb_status fmb_mesh_read(FILE *in, fmb_mesh_format f, const fmb_reader *how, fmb_mesh **out,
                         fmb_where *where)
{
    FMB_TRY(check_mesh_arguments(f, out, where));
    return fmb_parse_stream(in, how, parse_mesh, &(mesh_as){f, out}, where);
}

/* ---- TetGen ---------------------------------------------------------------------------------- */

/* One of the two files: a stream, or text where that is NULL. */
typedef struct tetgen_file {
    FILE *in;
    fmb_span text;
} tetgen_file;

typedef struct tetgen_part {
    fmb_mesh_read_fn *read;
    fmb_mesh_draft *d;
} tetgen_part;

static fmb_status parse_part_of_tetgen(fmb_cursor *c, void *self)
{
    const tetgen_part *part = self;
    FMB_TRY(fmb_io_check(c));
    return part->read(c, part->d);
}

/* All of it into a draft. */
static fmb_status read_part_of_tetgen(const tetgen_file *f, const fmb_reader *how,
                                      fmb_mesh_read_fn *read, fmb_mesh_draft *d, fmb_where *where)
{
    tetgen_part part = {read, d};
    return f->in ? fmb_parse_stream(f->in, how, parse_part_of_tetgen, &part, where)
                 : fmb_parse_memory(f->text.p, f->text.n, how, parse_part_of_tetgen, &part, where);
}

static fmb_status read_tetgen(const tetgen_file *points, const tetgen_file *cells,
                              const fmb_reader *how, fmb_mesh **out, fmb_where *where,
                              bool *in_cells)
{
    fmb_mem mem;
    fmb_mem_init(&mem, how->mem, 0);
    fmb_mesh_draft d = {.mem = &mem};
    fmb_cursor none = fmb_io_cursor("", 0, how, &mem, where);
    fmb_status st = read_part_of_tetgen(points, how, fmb_mesh_read_node, &d, where);
    *in_cells = st == FMB_OK;
    FMB_THEN(st, read_part_of_tetgen(cells, how, fmb_mesh_read_ele, &d, where));
    FMB_THEN(st, make_mesh_of_draft(&none, &d, out));
    fmb_mesh_draft_clear(&d);
    return st;
}

static fmb_status read_tetgen_files(const tetgen_file *points, const tetgen_file *cells,
                                    const fmb_reader *how, fmb_mesh **out, fmb_where *where,
                                    bool *in_cells)
{
    fmb_reader reader;
    fmb_where at = {0};
    bool second = false;
    FMB_TRY(fmb_io_take_reader(how, &reader, where));
    fmb_status st = read_tetgen(points, cells, &reader, out, &at, &second);
    if (st == FMB_ERR_PARSE && where)
        *where = at;
    if (in_cells)
        *in_cells = second;
    return st;
}

fmb_status fmb_mesh_read_tetgen(FILE *points, FILE *cells, const fmb_reader *how, fmb_mesh **out,
                                fmb_where *where, bool *in_cells)
{
    if (!points || !cells || !out)
        return fmb_io_refuse_argument(where, "points, cells or out is NULL");
    return read_tetgen_files(&(tetgen_file){.in = points}, &(tetgen_file){.in = cells}, how, out,
                             where, in_cells);
}

fmb_status fmb_mesh_parse_tetgen(const char *points, size_t points_size, const char *cells,
                                 size_t cells_size, const fmb_reader *how, fmb_mesh **out,
                                 fmb_where *where, bool *in_cells)
{
    if ((!points && points_size > 0) || (!cells && cells_size > 0) || !out)
        return fmb_io_refuse_argument(where, "points, cells or out is NULL");
    return read_tetgen_files(&(tetgen_file){.text = {points, points_size}},
                             &(tetgen_file){.text = {cells, cells_size}}, how, out, where,
                             in_cells);
}
