/* read.c: from a stream or a piece of memory to a system, and back: everything the formats share.
 */
#include <errno.h>
#include <string.h>

#include <fmb/io.h>

#include "io/io.h"
#include "io/utf8.h"

/* Digits that any text may grow by, and more for each byte of it. */
#define BUDGET_BASE     30000000
#define BUDGET_PER_BYTE 100

/* ---- is it text? ----------------------------------------------------------------------------- */

/* UTF-8 without NUL and control bytes other than tab and line ends. */
fmb_status fmb_io_check(fmb_cursor *c)
{
    for (const char *p = c->begin; p < c->end;) {
        unsigned char b = (unsigned char)*p;
        if (b == 0)
            return fmb_io_fail(c, p, "expected text, found a NUL byte");
        if ((b < 32 && (b < '\t' || b > '\r')) || b == 127)
            return fmb_io_fail(c, p, "expected text, found control byte 0x%02x", b);
        size_t n = b < 128 ? 1 : fmb_utf8_length(p, (size_t)(c->end - p));
        if (n == 0)
            return fmb_io_fail(c, p, "expected UTF-8 text, found byte 0x%02x", b);
        p += n;
    }
    return FMB_OK;
}

/* ---- parsing --------------------------------------------------------------------------------- */

fmb_cursor fmb_io_cursor(const char *text, size_t size, const fmb_reader *how, fmb_mem *mem,
                         fmb_where *where)
{
    fmb_cursor c = {.begin = text, .end = text + size, .how = how, .mem = mem, .where = where};
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        c.begin += 3;
    c.at = c.mark = c.begin;
    c.line = 1;
    c.budget = BUDGET_BASE;
    if (size < (SIZE_MAX - BUDGET_BASE) / BUDGET_PER_BYTE)
        c.budget += BUDGET_PER_BYTE * size;
    return c;
}

static fmb_status parse_with(fmb_cursor *c, const fmb_codec *codec, fmb_system *s)
{
    fmb_status st = fmb_io_check(c);
    if (st != FMB_OK)
        return st;
    if (!codec)
        codec = fmb_codec_guess(c);
    if (!codec->read)
        return fmb_io_fail_whole(c, "%s files cannot be read: built without %s", codec->name,
                                 codec->needs);
    return codec->read(c, s);
}

fmb_status fmb_system_parse(const char *text, size_t size, const fmb_reader *how, fmb_system **out,
                            fmb_where *where)
{
    const fmb_reader plain = {.format = FMB_FORMAT_AUTO};
    how = how ? how : &plain;
    const fmb_codec *codec = fmb_codec_of(how->format);
    if (!out || (!text && size > 0) || (!codec && how->format != FMB_FORMAT_AUTO))
        return FMB_ERR_ARG;
    fmb_mem mem;
    fmb_where at = {0};
    fmb_system *s;
    fmb_mem_init(&mem, how->mem, 0);
    fmb_cursor c = fmb_io_cursor(text ? text : "", size, how, &mem, &at);
    fmb_status st = fmb_system_new(0, how->mem, &s);
    if (st != FMB_OK)
        return st;
    st = parse_with(&c, codec, s);
    if (st == FMB_OK) {
        *out = s;
        return FMB_OK;
    }
    fmb_system_free(s);
    if (st == FMB_ERR_PARSE && where)
        *where = at;
    return st;
}

/* ---- streams --------------------------------------------------------------------------------- */

typedef struct bytes {
    char *p;
    size_t size, capacity;
} bytes;

/* All of a stream. Memory follows what has been read, never what a stream claims to hold. */
static fmb_status slurp(FILE *in, bytes *b, fmb_mem *mem)
{
    for (;;) {
        fmb_status st = fmb_mem_reserve(mem, (void **)&b->p, &b->capacity, b->size + (1 << 14), 1);
        if (st != FMB_OK)
            return st;
        size_t n = fread(b->p + b->size, 1, b->capacity - b->size, in);
        b->size += n;
        if (n == 0)
            return ferror(in) ? FMB_ERR_IO : FMB_OK;
    }
}

fmb_status fmb_system_read(FILE *in, const fmb_reader *how, fmb_system **out, fmb_where *where)
{
    if (!in || !out)
        return FMB_ERR_ARG;
    fmb_mem mem;
    bytes b = {0};
    fmb_mem_init(&mem, how ? how->mem : NULL, 0);
    fmb_status st = slurp(in, &b, &mem);
    int cause = errno;
    if (st == FMB_OK)
        st = fmb_system_parse(b.p, b.size, how, out, where);
    fmb_mem_put(&mem, b.p, b.capacity, 1);
    if (st == FMB_ERR_IO)
        errno = cause;
    return st;
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
