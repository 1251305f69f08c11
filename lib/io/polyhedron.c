/* polyhedron.c: a polyhedron by its rows or by its generators, whichever a text has. */
#include <fmb/lift.h>

#include "io/core/stream.h"
#include "io/sniff.h"

typedef struct polyhedron {
    fmb_system **s;
    fmb_generators **g;
} polyhedron;

static fmb_status parse_polyhedron(fmb_cursor *c, void *self)
{
    const polyhedron *p = self;
    fmb_system *rows = NULL;
    fmb_generators *generators = NULL;
    fmb_format f = c->how->format;
    size_t size = (size_t)(c->end - c->begin);
    bool is_v = (f == FMB_FORMAT_AUTO || f == FMB_FORMAT_INE) && fmb_sniff_generators(c);
    fmb_status st = is_v ? fmb_generators_parse(c->begin, size, c->how, &generators, c->where)
                         : fmb_system_parse(c->begin, size, c->how, &rows, c->where);
    if (st == FMB_OK) {
        *p->s = rows;
        *p->g = generators;
    }
    return st;
}

fmb_status fmb_polyhedron_parse(const char *text, size_t size, const fmb_reader *how,
                                fmb_system **s, fmb_generators **g, fmb_where *where)
{
    return s && g ? fmb_parse_memory(text, size, how, parse_polyhedron, &(polyhedron){s, g}, where)
                  : fmb_io_refuse_argument(where, "s or g is NULL");
}

fmb_status fmb_polyhedron_read(FILE *in, const fmb_reader *how, fmb_system **s, fmb_generators **g,
                               fmb_where *where)
{
    return s && g ? fmb_parse_stream(in, how, parse_polyhedron, &(polyhedron){s, g}, where)
                  : fmb_io_refuse_argument(where, "s or g is NULL");
}
