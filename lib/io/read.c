/* read.c: from a stream or a piece of memory to a system, and back: everything the formats share.
 */
#include "base/memory_stream.h"
#include "io/core/stream.h"
#include "io/formats.h"

/* ---- parsing --------------------------------------------------------------------------------- */

/* Neither a row nor a variable was found: is that a system all the same? One in .ine tells its
 * size; of others nothing tells them from a file that was never written. */
static bool says_nothing(const fmb_codec *codec, const fmb_system *s)
{
    return fmb_system_rows(s) == 0 && fmb_system_dim(s) == 0 && codec->format != FMB_FORMAT_INE;
}

static fmb_status read_with_codec(fmb_cursor *c, fmb_system *s)
{
    const fmb_codec *codec = fmb_codec_of(c->how->format);
    fmb_status st = fmb_io_check(c);
    if (st != FMB_OK)
        return st;
    if (!codec)
        codec = fmb_codec_guess(c);
    st = codec->read(c, s);
    if (st == FMB_OK && says_nothing(codec, s))
        st = fmb_io_fail(c, NULL, "expected rows or variables, found none");
    return st;
}

static fmb_status parse_with_codec(fmb_cursor *c, void *out)
{
    fmb_system *s = NULL;
    fmb_status st = fmb_system_new(0, c->how->mem, &s);
    if (st == FMB_OK)
        st = read_with_codec(c, s);
    if (st == FMB_OK)
        *(fmb_system **)out = s;
    else
        fmb_system_free(s);
    return st;
}

static fmb_status take_arguments(const fmb_reader *how, fmb_reader *ours, fmb_system **out,
                                 fmb_where *where)
{
    fmb_status st = fmb_io_take_reader(how, ours, where);
    if (st == FMB_OK && !out)
        st = fmb_io_refuse_argument(where, "out is NULL");
    if (st == FMB_OK && ours->format != FMB_FORMAT_AUTO && !fmb_codec_of(ours->format))
        st = fmb_io_refuse_argument(where, "how->format is no fmb_format");
    return st;
}

fmb_status fmb_system_parse(const char *text, size_t size, const fmb_reader *how, fmb_system **out,
                            fmb_where *where)
{
    fmb_reader reader;
    fmb_status st = take_arguments(how, &reader, out, where);
    return st == FMB_OK ? fmb_parse_memory(text, size, &reader, parse_with_codec, out, where) : st;
}

/* ---- streams --------------------------------------------------------------------------------- */

fmb_status fmb_system_read(FILE *in, const fmb_reader *how, fmb_system **out, fmb_where *where)
{
    fmb_reader reader;
    fmb_status st = take_arguments(how, &reader, out, where);
    return st == FMB_OK ? fmb_parse_stream(in, &reader, parse_with_codec, out, where) : st;
}

fmb_status fmb_system_write(const fmb_system *s, fmb_format f, FILE *out)
{
    const fmb_codec *codec = fmb_codec_of(f);
    if (!s || !out || !codec || !codec->write)
        return FMB_ERR_ARG;
    fmb_status st = codec->write(s, out);
    if (st == FMB_OK && (fflush(out) != 0 || ferror(out)))
        st = FMB_ERR_IO;
    return st;
}

typedef struct system_as {
    const fmb_system *s;
    fmb_format format;
} system_as;

static fmb_status write_system_as(const void *self, FILE *out)
{
    const system_as *w = self;
    return fmb_system_write(w->s, w->format, out);
}

fmb_status fmb_system_print(const fmb_system *s, fmb_format f, char *text, size_t size,
                            size_t *length)
{
    return fmb_memory_print(write_system_as, &(system_as){s, f}, text, size, length);
}
