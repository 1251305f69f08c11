/* polyhedron.c: a polyhedron by its rows or by its generators, whichever a text has. */
#include <fmb/lift.h>

#include "io/core/stream.h"
#include "io/sniff.h"

static bool is_v_representation(const char *text, size_t size, const fmb_reader *how)
{
    fmb_mem mem;
    fmb_where at;
    fmb_format f = how->format;
    fmb_mem_init(&mem, NULL, 0);
    fmb_cursor c = fmb_io_cursor(text, size, how, &mem, &at);
    return (f == FMB_FORMAT_AUTO || f == FMB_FORMAT_INE) && size <= fmb_io_max_bytes(how) &&
           fmb_sniff_generators(&c);
}

fmb_status fmb_polyhedron_parse(const char *text, size_t size, const fmb_reader *how,
                                fmb_system **s, fmb_generators **g, fmb_where *where)
{
    fmb_system *rows = NULL;
    fmb_generators *generators = NULL;
    fmb_reader reader;
    if (!s || !g)
        return fmb_io_refuse_argument(where, "s or g is NULL");
    fmb_status st = fmb_io_take_reader(how, &reader, where);
    if (st != FMB_OK)
        return st;
    st = text && is_v_representation(text, size, &reader)
             ? fmb_generators_parse(text, size, &reader, &generators, where)
             : fmb_system_parse(text, size, &reader, &rows, where);
    if (st == FMB_OK) {
        *s = rows;
        *g = generators;
    }
    return st;
}

typedef struct polyhedron {
    fmb_system **s;
    fmb_generators **g;
} polyhedron;

static fmb_status parse_polyhedron(const char *text, size_t size, const fmb_reader *how, void *self,
                                   fmb_where *where)
{
    const polyhedron *p = self;
    return fmb_polyhedron_parse(text, size, how, p->s, p->g, where);
}

fmb_status fmb_polyhedron_read(FILE *in, const fmb_reader *how, fmb_system **s, fmb_generators **g,
                               fmb_where *where)
{
    return s && g ? fmb_parse_stream(in, how, parse_polyhedron, &(polyhedron){s, g}, where)
                  : fmb_io_refuse_argument(where, "s or g is NULL");
}
