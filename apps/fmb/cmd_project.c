/* cmd_project.c: fmb project FILE. */
#include <stdlib.h>

#include "common/message.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/shadow.h"
#include "fmb/variables.h"

enum { KEY_KEEP = 0x200, KEY_ELIMINATE, KEY_TO };

static const struct argp_option options[] = {
    {"keep", KEY_KEEP, "NAMES", 0, "Project on these variables (x,y)", 1},
    {"eliminate", KEY_ELIMINATE, "NAMES", 0, "Eliminate these variables (z,t)", 1},
    {"to", KEY_TO, "FORMAT", 0,
     "Write this format: fmb|ine|smt2 (default: that of FILE where it can be written, else fmb)",
     1},
    {0}};

typedef struct request {
    app_names keep, eliminate;
    fmb_format to;
} request;

static error_t parse(int key, char *arg, struct argp_state *state)
{
    request *r = state->input;
    switch (key) {
    case KEY_KEEP:
        if (!app_names_add(&r->keep, arg))
            argp_error(state, "--keep: given too often");
        return 0;
    case KEY_ELIMINATE:
        if (!app_names_add(&r->eliminate, arg))
            argp_error(state, "--eliminate: given too often");
        return 0;
    case KEY_TO:
        if (!app_format_to(arg, &r->to))
            argp_error(state, "--to: expected fmb|ine|smt2, found '%s'", arg);
        return 0;
    case ARGP_KEY_END:
        if (r->keep.lists > 0 && r->eliminate.lists > 0)
            argp_error(state, "--keep and --eliminate exclude each other");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp own = {.options = options, .parser = parse};

static const app_usage usage = {
    .args = "FILE",
    .doc = "The projection of the system in FILE on some of its variables, as an irredundant "
           "system. Without --keep and --eliminate the file itself must ask for a projection (a "
           "project or eliminate line in .ine, project: in .fmb). The projection of an infeasible "
           "system is the row "
           "0 <= -1."
           "\v"
           "Exit codes: 0 done, 1 infeasible, 2 undecided: rows that follow, perhaps too few.\n"
           "\n"
           "Examples:\n"
           "  fmb project shape.fmb --keep x,y\n"
           "  fmb project shape.ine --eliminate x4 --to smt2\n",
    .own = &own,
};

static int requested_by_file(const fmb_system *s, int **vars, int *n)
{
    if (!fmb_system_asks_projection(s))
        return app_error(APP_USAGE, "--keep or --eliminate is missing: the file asks for nothing");
    *vars = app_need(malloc(((size_t)fmb_system_dim(s) + 1) * sizeof **vars));
    *n = 0;
    for (int j = 0; j < fmb_system_dim(s); j++)
        if (fmb_system_is_kept(s, j))
            (*vars)[(*n)++] = j;
    return APP_YES;
}

static int choose(const request *r, const fmb_system *s, int **vars, int *n)
{
    if (r->keep.lists > 0)
        return app_names_select(&r->keep, s, true, vars, n);
    if (r->eliminate.lists > 0)
        return app_names_select(&r->eliminate, s, false, vars, n);
    return requested_by_file(s, vars, n);
}

int cmd_project(int argc, char **argv)
{
    app_ask ask;
    request r = {.keep = {.option = "--keep"}, .eliminate = {.option = "--eliminate"}};
    app_ask_parse(&ask, &usage, &r, argc, argv);
    if (ask.proof)
        ask.options.evidence = FMB_EVIDENCE_WHOLE;
    app_session s;
    int *vars = NULL, n = 0;
    fmb_system *shadow = NULL;
    int code = app_session_open(&s, &ask);
    if (code == 0)
        code = choose(&r, s.system, &vars, &n);
    if (code == 0) {
        app_integers_note(&s);
        app_session_begin(&s);
        fmb_status st = fmb_project(s.solver, s.system, vars, n, &shadow, &s.result);
        code = app_session_end(&s, st);
    }
    if (code == 0)
        code = app_shadow_report(&s, shadow, r.to ? r.to : app_source_written(&ask.source));
    fmb_system_free(shadow);
    free(vars);
    return app_session_close(&s, code);
}
