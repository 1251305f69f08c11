/* cmd_hull.c: fmb hull FILE. */
#include <fmb/generators.h>

#include "common/message.h"
#include "common/options.h"
#include "common/source.h"
#include "fmb/ask.h"
#include "fmb/commands.h"

enum { KEY_TO = 0x200 };

static const struct argp_option options[] = {
    {"to", KEY_TO, "FORMAT", 0, "Write this format: fmb|ine|smt2 (default ine)", 1}, {0}};

typedef struct request {
    app_source source;
    fmb_format to;
} request;

static error_t parse(int key, char *arg, struct argp_state *state)
{
    request *r = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &r->source;
        return 0;
    case KEY_TO:
        if (!app_format_to(arg, &r->to))
            argp_error(state, "--to: expected fmb|ine|smt2, found '%s'", arg);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] =
    "An irredundant system whose solutions are the convex hull of the vertices, rays and lines in "
    "FILE, "
    "a V-representation (.ext) of cddlib and lrslib."
    "\v"
    "Exit codes: 0 done, 1 there is no vertex, so the hull is empty, 2 undecided.\n"
    "\n"
    "Examples:\n"
    "  fmb vertices cube.ine | fmb hull - --to fmb\n";

static int find_hull(const fmb_generators *g, fmb_system **out, fmb_result *res)
{
    fmb_options o = fmb_options_default();
    fmb_solver *v = NULL;
    o.max_bytes = app_ask_half_of_memory();
    fmb_status st = fmb_solver_new(&o, NULL, &v);
    if (st == FMB_OK)
        st = fmb_hull(v, g, out, res);
    fmb_solver_free(v);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

static int report(const request *r, const fmb_system *hull, const fmb_result *res)
{
    if (!hull) {
        fprintf(stderr, "fmb: undecided (%s)\n", fmb_stop_text(res->stop));
        return APP_UNDECIDED;
    }
    int code = app_source_write(hull, r->to);
    return code == APP_YES && res->verdict == FMB_INFEASIBLE ? APP_NO : code;
}

int cmd_hull(int argc, char **argv)
{
    static const struct argp_child children[] = {{&app_source_argp, 0, NULL, 0},
                                                 {NULL, 0, NULL, 0}};
    static const struct argp whole = {
        .options = options, .parser = parse, .args_doc = "FILE", .doc = doc, .children = children};
    request r = {.to = FMB_FORMAT_INE};
    fmb_generators *g = NULL;
    fmb_system *hull = NULL;
    fmb_result res;
    app_options_parse(&whole, argc, argv, &r);
    int code = app_source_read_generators(&r.source, &g);
    if (code == APP_YES)
        code = find_hull(g, &hull, &res);
    if (code == APP_YES)
        code = report(&r, hull, &res);
    fmb_system_free(hull);
    fmb_generators_free(g);
    return code;
}
