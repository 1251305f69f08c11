/* cmd_convert.c: fmb convert FILE --to FORMAT. */
#include <string.h>

#include "common/message.h"
#include "common/options.h"
#include "common/source.h"
#include "fmb/commands.h"
#include "fmb/convert_pairs.h"

enum { KEY_TO = 0x200, KEY_NEAREST };

static const struct argp_option options[] = {
    {"to", KEY_TO, APP_FORMATS_TO "|pairs", 0,
     "Write this format; pairs: FILE has pairs of frames, as fmb intersect reads them, and they "
     "are "
     "written in binary",
     1},
    {"nearest", KEY_NEAREST, NULL, 0, "(pairs) A number means the double nearest to it", 1},
    {0}};

typedef struct request {
    app_source source;
    fmb_format to;
    bool pairs, nearest;
} request;

static error_t parse(int key, char *arg, struct argp_state *state)
{
    request *r = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &r->source;
        return 0;
    case KEY_TO:
        r->pairs = strcmp(arg, "pairs") == 0;
        if (!r->pairs && !app_format_to(arg, &r->to))
            argp_error(state, "--to: expected " APP_FORMATS_TO "|pairs, found '%s'", arg);
        return 0;
    case KEY_NEAREST:
        r->nearest = true;
        return 0;
    case ARGP_KEY_END:
        if (!r->to && !r->pairs)
            argp_error(state, "--to FORMAT is missing");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] =
    "Write the system in FILE in another format, row by row in the same order."
    "\v"
    "Examples:\n"
    "  fmb convert afiro.mps --to fmb\n"
    "  fmb convert - --format ine --to smt2 < cube.ine\n"
    "  fmb convert rooms.jsonl --to pairs --nearest > rooms.pairs\n";

int cmd_convert(int argc, char **argv)
{
    static const struct argp_child children[] = {{&app_source_argp, 0, NULL, 0},
                                                 {NULL, 0, NULL, 0}};
    static const struct argp whole = {
        .options = options, .parser = parse, .args_doc = "FILE", .doc = doc, .children = children};
    request r = {.to = FMB_FORMAT_AUTO};
    app_options_parse(&whole, argc, argv, &r);
    if (r.pairs)
        return convert_pairs(&r.source, r.nearest);
    fmb_system *s = NULL;
    int code = app_source_read(&r.source, &s);
    if (code == APP_YES && r.to == FMB_FORMAT_INE && !r.source.quiet && app_source_has_integers(s))
        fputs("fmb: .ine cannot say which variables are integer\n", stderr);
    if (code == APP_YES)
        code = app_source_write(s, r.to);
    fmb_system_free(s);
    return code;
}
