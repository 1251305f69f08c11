/* source.c: see source.h. */
#include "common/source.h"

#include <errno.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"

#define FORMATS "auto|fmb|ine|ieq|smt2|mps|lp"

static const struct argp_option source_options[] = {
    {"format", 'f', "FORMAT", 0,
     "FILE is in this format: " FORMATS " (default auto: by name, else by content)", 1},
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

static void warn(void *self, const fmb_where *where)
{
    const app_source *src = self;
    if (!src->quiet)
        app_warning_at(app_file_shown(src->file), where);
}

int app_source_outcome(fmb_status st, const char *path, const fmb_where *where)
{
    const char *file = app_file_shown(path);
    switch (st) {
    case FMB_OK:
        return APP_YES;
    case FMB_ERR_PARSE:
    case FMB_ERR_ARG:
        return app_error_at(APP_BAD_INPUT, file, where);
    case FMB_ERR_IO:
        return app_error(APP_CANNOT_OPEN, "%s: %s", file,
                         errno ? strerror(errno) : "reading failed");
    default:
        return app_status_error(st);
    }
}

int app_source_read(const app_source *src, fmb_system **out)
{
    FILE *in;
    int code = app_file_open(src->file, &in);
    if (code != APP_YES)
        return code;
    app_source self = *src;
    fmb_reader how = {.format = src->format, .warn = warn, .self = &self};
    if (how.format == FMB_FORMAT_AUTO)
        how.format = fmb_format_of_name(src->file);
    fmb_where where = {0};
    errno = 0;
    fmb_status st = fmb_system_read(in, &how, out, &where);
    code = app_source_outcome(st, src->file, &where);
    app_file_close_input(in);
    return code;
}

static bool can_write(fmb_format f)
{
    return f == FMB_FORMAT_TEXT || f == FMB_FORMAT_INE || f == FMB_FORMAT_SMT2;
}

fmb_format app_source_written(const app_source *src)
{
    fmb_format f = src->format ? src->format : fmb_format_of_name(src->file);
    return can_write(f) ? f : FMB_FORMAT_TEXT;
}

int app_source_write(const fmb_system *s, fmb_format f)
{
    fmb_status st = fmb_system_write(s, f, stdout);
    return st == FMB_OK || st == FMB_ERR_IO ? APP_YES : app_status_error(st);
}

bool app_format_to(const char *word, fmb_format *out)
{
    return fmb_format_parse(word, out) && can_write(*out);
}
