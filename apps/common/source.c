/* source.c: see source.h. */
#include "common/source.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "common/budget.h"
#include "common/file.h"
#include "common/message.h"
#include "common/text.h"
#include "common/value.h"

enum { KEY_MAX_INPUT = 0x300 };

#define FORMATS "auto|fmb|ine|ieq|smt2|mps|lp"

static const struct argp_option source_options[] = {
    {"format", 'f', FORMATS, 0, "FILE is in this format (default auto: by name, else by content)",
     1},
    {"max-input", KEY_MAX_INPUT, "BYTES", 0, "Refuse a FILE that is longer (default 1073741824)",
     1},
    {"quiet", 'q', NULL, 0, "Nothing on standard error but errors", 1},
    {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    app_source *src = state->input;
    switch (key) {
    case 'f':
        if (!fmb_format_parse(arg, &src->format))
            argp_error(state, "--format: expected " FORMATS ", found '%s'", arg);
        return 0;
    case KEY_MAX_INPUT:
        src->max_input = (size_t)app_value_whole("--max-input", arg, 1, SIZE_MAX, state);
        return 0;
    case 'q':
        src->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (src->file)
            return ARGP_ERR_UNKNOWN;
        src->file = arg;
        return 0;
    case ARGP_KEY_END:
        if (!src->file)
            argp_error(state, "FILE is missing (- is standard input)");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp app_source_argp = {.options = source_options, .parser = parse};

app_kind (*app_source_kind)(const char *path);

/* "; which command reads it" for a file that holds something else than was wanted. */
static const char *hint_at_kind(app_kind wanted, const char *path)
{
    static const char *const HINT[] = {
        [APP_KIND_UNKNOWN] = "",
        [APP_KIND_SYSTEM] = "; this looks like a system of inequalities, for `fmb solve`",
        [APP_KIND_FRAMES] = "; this looks like pairs of frames, for `fmb intersect`",
        [APP_KIND_MESH] = "; this looks like a mesh, for `fmb mesh`",
    };
    app_kind found = app_source_kind ? app_source_kind(path) : APP_KIND_UNKNOWN;
    return found == wanted ? "" : HINT[found];
}

static app_place place_in(const char *file, const fmb_where *where)
{
    return (app_place){file, where->line, where->line > 0 ? where->column : 0};
}

static void warn(void *self, const fmb_where *where)
{
    const app_source *src = self;
    char text[sizeof where->text + sizeof "warning: "];
    snprintf(text, sizeof text, "warning: %s", where->text);
    if (!src->quiet)
        app_warn_at(place_in(app_file_shown(src->file), where), text);
}

fmb_status app_source_without_pairs(fmb_where *where)
{
    *where = (fmb_where){0};
    snprintf(where->text, sizeof where->text, "expected pairs of frames, found none");
    return FMB_ERR_PARSE;
}

int app_source_outcome(fmb_status st, const char *path, const fmb_where *where)
{
    return app_source_outcome_of(APP_KIND_SYSTEM, st, path, where);
}

int app_source_outcome_of(app_kind wanted, fmb_status st, const char *path, const fmb_where *where)
{
    const char *file = app_file_shown(path);
    switch (st) {
    case FMB_OK:
        return APP_YES;
    case FMB_ERR_PARSE:
    case FMB_ERR_ARG:
        return app_error_at(place_in(file, where), APP_BAD_INPUT, "%s%s", where->text,
                            st == FMB_ERR_PARSE ? hint_at_kind(wanted, path) : "");
    case FMB_ERR_IO:
        return app_error_at((app_place){.file = file}, APP_CANNOT_OPEN, "%s",
                            errno ? strerror(errno) : "reading failed");
    default:
        return app_status_error(st);
    }
}

fmb_reader app_source_reader(app_source *src)
{
    return (fmb_reader){.size = sizeof(fmb_reader),
                        .format = src->format,
                        .mem = app_budget_alloc(),
                        .warn = warn,
                        .self = src,
                        .max_bytes = src->max_input};
}

/* The kind of result wanted from a reader of the library. */
typedef struct wanted {
    fmb_system **system;
    fmb_generators **generators; /* or NULL: a system alone */
    const fmb_system *map_over;  /* or NULL: no map */
} wanted;

static fmb_status read_wanted(FILE *in, const fmb_reader *how, const wanted *w, fmb_where *where)
{
    if (w->map_over)
        return fmb_system_read_graph(in, how, w->map_over, w->system, where);
    if (w->generators)
        return fmb_polyhedron_read(in, how, w->system, w->generators, where);
    return fmb_system_read(in, how, w->system, where);
}

static int read_file(const app_source *src, const wanted *w)
{
    FILE *in;
    int code = app_file_open(src->file, &in);
    if (code != APP_YES)
        return code;
    app_source self = *src;
    fmb_reader how = app_source_reader(&self);
    if (how.format == FMB_FORMAT_AUTO)
        how.format = fmb_format_of_name(src->file);
    fmb_where where = {0};
    errno = 0;
    fmb_status st = read_wanted(in, &how, w, &where);
    code = app_source_outcome(st, src->file, &where);
    app_file_close_input(in);
    return code;
}

int app_source_read(const app_source *src, fmb_system **out)
{
    return read_file(src, &(wanted){.system = out});
}

bool app_source_has_integers(const fmb_system *s)
{
    int j = 0;
    while (j < fmb_system_dim(s) && !fmb_system_is_integer(s, j))
        j++;
    return j < fmb_system_dim(s);
}

bool app_source_is_script(const app_source *src)
{
    return (src->format ? src->format : fmb_format_of_name(src->file)) == FMB_FORMAT_SMT2;
}

int app_source_read_script(app_source *src, fmb_script **out)
{
    FILE *in;
    int code = app_file_open(src->file, &in);
    if (code != APP_YES)
        return code;
    fmb_reader how = app_source_reader(src);
    fmb_where where = {0};
    errno = 0;
    code = app_source_outcome(fmb_script_read(in, &how, out, &where), src->file, &where);
    app_file_close_input(in);
    return code;
}

int app_source_read_polyhedron(const app_source *src, fmb_system **s, fmb_generators **g)
{
    return read_file(src, &(wanted){.system = s, .generators = g});
}

int app_source_read_graph(const app_source *src, const fmb_system *s, fmb_system **out)
{
    return read_file(src, &(wanted){.system = out, .map_over = s});
}

/* MPS and LP are written as text, as with a row for each bound authors would not recognize them. */
fmb_format app_source_written(const app_source *src)
{
    fmb_format f = src->format ? src->format : fmb_format_of_name(src->file);
    return f == FMB_FORMAT_INE || f == FMB_FORMAT_SMT2 ? f : FMB_FORMAT_TEXT;
}

/* MPS and LP, which are all that refuse some systems, cannot say what? */
static int refuse_to_write(const fmb_system *s, fmb_format f)
{
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        const char *label = fmb_system_label(s, i);
        if (fmb_system_rel(s, i) == FMB_LT)
            return app_error(APP_BAD_INPUT, "row %zu%s%s%s is strict, which .%s cannot say", i + 1,
                             label ? " (" : "", label ? label : "", label ? ")" : "",
                             fmb_format_text(f));
    }
    if (fmb_system_dim(s) == 0)
        return app_error(APP_BAD_INPUT, "there are no variables, which .%s cannot say",
                         fmb_format_text(f));
    if (fmb_system_rows(s) == 0 && fmb_system_sense(s) == FMB_SENSE_NONE)
        return app_error(APP_BAD_INPUT, "there is neither a row nor an objective, as .%s needs",
                         fmb_format_text(f));
    return app_error(APP_BAD_INPUT,
                     "the objective has numbers that are no finite decimals, as .%s needs",
                     fmb_format_text(f));
}

int app_source_write(const fmb_system *s, fmb_format f)
{
    fmb_status st = fmb_system_write(s, f, stdout);
    if (st == FMB_ERR_ARG)
        return refuse_to_write(s, f);
    return st == FMB_OK || st == FMB_ERR_IO ? APP_YES : app_status_error(st);
}

bool app_format_to(const char *word, fmb_format *out)
{
    return fmb_format_parse(word, out) && *out != FMB_FORMAT_AUTO && *out != FMB_FORMAT_IEQ;
}
