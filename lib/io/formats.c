/* formats.c: reading and writing systems and polyhedra in all formats, and guessing the format of a
 * text. To add a format: a folder of its own, and a line in the table.
 */
#include <fmb/lift.h>
#include <string.h>

#include "base/memory_stream.h"
#include "io/core/io_private.h"
#include "io/core/stream.h"

/* One format. */
typedef struct codec {
    fmb_format format;
    const char *name; /* as in --format; ".name" is its ending */
    fmb_read_fn *read;
    fmb_write_fn *write;                /* NULL: reading only */
    bool (*sniff)(const fmb_cursor *c); /* does the text look like it? c is at the start */
} codec;

/* ---- guessing -------------------------------------------------------------------------------- */

/* Each format is recognized by lines that the others cannot have. */

/* Some line consists of exactly this word. */
static bool has_line_of_word(fmb_cursor c, const char *word)
{
    for (; c.at < c.end; fmb_next_line(&c)) {
        fmb_skip_blanks(&c);
        if (fmb_span_is_nocase(fmb_scan_word(&c), word)) {
            fmb_skip_blanks(&c);
            if (fmb_peek(&c) == '\n' || fmb_peek(&c) < 0)
                return true;
        }
    }
    return false;
}

static bool sniffs_ine(const fmb_cursor *c)
{
    return has_line_of_word(*c, "begin") || has_line_of_word(*c, "H-representation") ||
           has_line_of_word(*c, "V-representation");
}

/* Is the .ine text a V-representation? */
static bool sniffs_generators(const fmb_cursor *c)
{
    return has_line_of_word(*c, "V-representation");
}

static bool sniffs_ieq(const fmb_cursor *c)
{
    return has_line_of_word(*c, "INEQUALITIES_SECTION");
}

/* Skip blank lines and lines that begin with this byte. */
static void skip_comment_lines(fmb_cursor *c, int mark)
{
    fmb_skip_space(c);
    while (fmb_peek(c) == mark) {
        fmb_next_line(c);
        fmb_skip_space(c);
    }
}

/* Does the text begin with an S-expression whose head is a command? */
static bool sniffs_smt2(const fmb_cursor *from)
{
    static const char *const heads[] = {"set-",   "declare-", "define-", "assert",
                                        "check-", "push",     "echo",    "exit"};
    fmb_cursor c = *from;
    skip_comment_lines(&c, ';');
    if (!fmb_accept(&c, "("))
        return false;
    fmb_skip_space(&c);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++)
        if (fmb_accept(&c, heads[i]))
            return true;
    return false;
}

static bool sniffs_mps(const fmb_cursor *c)
{
    return has_line_of_word(*c, "ROWS") && has_line_of_word(*c, "COLUMNS");
}

/* Does the text begin with an objective, and have a section of rows? */
static bool sniffs_lp(const fmb_cursor *from)
{
    static const char *const heads[] = {"min", "max", "minimize", "maximize", "minimum", "maximum"};
    static const char *const rows[] = {"subject", "such", "st", "s.t.",
                                       "st."}; /* two have two words */
    bool objective = false, section = false;
    fmb_cursor c = *from;
    skip_comment_lines(&c, '\\');
    fmb_span word = fmb_scan_word(&c);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++)
        objective = objective || fmb_span_is_nocase(word, heads[i]);
    const char *line = c.at;
    for (fmb_skip_space(&c); objective && !section && c.at < c.end; fmb_skip_space(&c)) {
        bool first = memchr(line, '\n', (size_t)(c.at - line)) != NULL;
        word = fmb_scan_word(&c);
        line = c.at;
        for (size_t i = 0; i < (first ? sizeof rows / sizeof *rows : 2); i++)
            section = section || fmb_span_is_nocase(word, rows[i]);
    }
    return section;
}

/* ---- the table ------------------------------------------------------------------------------- */

/* Guessing takes the first that fits. */
static const codec codecs[] = {
    {FMB_FORMAT_INE, "ine", fmb_read_ine, fmb_write_ine, sniffs_ine},
    {FMB_FORMAT_IEQ, "ieq", fmb_read_ieq, NULL, sniffs_ieq},
    {FMB_FORMAT_SMT2, "smt2", fmb_read_smt2, fmb_write_smt2, sniffs_smt2},
    {FMB_FORMAT_MPS, "mps", fmb_read_mps, fmb_write_mps, sniffs_mps},
    {FMB_FORMAT_LP, "lp", fmb_read_lp, fmb_write_lp, sniffs_lp},
    {FMB_FORMAT_TEXT, "fmb", fmb_read_text, fmb_write_text, NULL},
};

enum { CODECS = sizeof codecs / sizeof *codecs };

/* Entry of a format; NULL for AUTO and nonsense. */
static const codec *find_codec(fmb_format f)
{
    for (size_t i = 0; i < CODECS; i++)
        if (codecs[i].format == f)
            return &codecs[i];
    return NULL;
}

/* By content; text for people (.fmb) if nothing else fits. */
static const codec *guess_codec(const fmb_cursor *c)
{
    for (size_t i = 0; i < CODECS; i++)
        if (codecs[i].sniff && codecs[i].sniff(c))
            return &codecs[i];
    return find_codec(FMB_FORMAT_TEXT);
}

const char *fmb_format_text(fmb_format f)
{
    const codec *known = find_codec(f);
    return known ? known->name : "auto";
}

bool fmb_format_parse(const char *word, fmb_format *out)
{
    fmb_format f = FMB_FORMAT_AUTO;
    if (!word || !out)
        return false;
    for (size_t i = 0; i < CODECS; i++)
        if (strcmp(codecs[i].name, word) == 0)
            f = codecs[i].format;
    if (f == FMB_FORMAT_AUTO && strcmp(word, "auto") != 0)
        return false;
    *out = f;
    return true;
}

fmb_format fmb_format_of_name(const char *path)
{
    const char *dot = path ? strrchr(path, '.') : NULL;
    if (!dot || strchr(dot, '/'))
        return FMB_FORMAT_AUTO;
    fmb_span ending = {dot + 1, strlen(dot + 1)};
    for (size_t i = 0; i < CODECS; i++)
        if (fmb_span_is_nocase(ending, codecs[i].name))
            return codecs[i].format;
    return FMB_FORMAT_AUTO;
}

/* ---- parsing --------------------------------------------------------------------------------- */

/* Is the text empty, with neither rows nor variables? In .ine a header makes it a system; in other
 * formats it cannot be distinguished from a file that was never written. */
static bool says_nothing(const codec *by, const fmb_system *s)
{
    return fmb_system_rows(s) == 0 && fmb_system_dim(s) == 0 && by->format != FMB_FORMAT_INE;
}

static fmb_status read_with_codec(fmb_cursor *c, fmb_system *s)
{
    const codec *by = find_codec(c->how->format);
    FMB_TRY(fmb_io_check(c));
    if (!by)
        by = guess_codec(c);
    FMB_TRY(by->read(c, s));
    if (says_nothing(by, s))
        return fmb_io_fail(c, NULL, "expected rows or variables, found none");
    return FMB_OK;
}

static fmb_status parse_with_codec(fmb_cursor *c, void *out)
{
    fmb_system *s = NULL;
    fmb_status st = fmb_system_new(0, c->how->mem, &s);
    FMB_THEN(st, read_with_codec(c, s));
    if (st == FMB_OK)
        *(fmb_system **)out = s;
    else
        fmb_system_free(s);
    return st;
}

static fmb_status take_arguments(const fmb_reader *how, fmb_reader *ours, fmb_system **out,
                                 fmb_where *where)
{
    FMB_TRY(fmb_io_take_reader(how, ours, where));
    if (!out)
        FMB_TRY(fmb_io_refuse_argument(where, "out is NULL"));
    if (ours->format != FMB_FORMAT_AUTO && !find_codec(ours->format))
        FMB_TRY(fmb_io_refuse_argument(where, "how->format is no fmb_format"));
    return FMB_OK;
}

fmb_status fmb_system_parse(const char *text, size_t size, const fmb_reader *how, fmb_system **out,
                            fmb_where *where)
{
    fmb_reader reader;
    FMB_TRY(take_arguments(how, &reader, out, where));
    return fmb_parse_memory(text, size, &reader, parse_with_codec, out, where);
}

/* ---- streams --------------------------------------------------------------------------------- */

fmb_status fmb_system_read(FILE *in, const fmb_reader *how, fmb_system **out, fmb_where *where)
{
    fmb_reader reader;
    FMB_TRY(take_arguments(how, &reader, out, where));
    return fmb_parse_stream(in, &reader, parse_with_codec, out, where);
}

fmb_status fmb_system_write(const fmb_system *s, fmb_format f, FILE *out)
{
    const codec *by = find_codec(f);
    if (!s || !out || !by || !by->write)
        return FMB_ERR_ARG;
    FMB_TRY(by->write(s, out));
    return fflush(out) != 0 || ferror(out) ? FMB_ERR_IO : FMB_OK;
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

/* ---- polyhedra: by rows or by generators, whichever a text has ------------------------------- */

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
    bool is_v = (f == FMB_FORMAT_AUTO || f == FMB_FORMAT_INE) && sniffs_generators(c);
    FMB_TRY(is_v ? fmb_generators_parse(c->begin, size, c->how, &generators, c->where)
                 : fmb_system_parse(c->begin, size, c->how, &rows, c->where));
    *p->s = rows;
    *p->g = generators;
    return FMB_OK;
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
