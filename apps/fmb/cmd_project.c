/* cmd_project.c: fmb project FILE. */
#include <stdlib.h>

#include "common/message.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/projection.h"
#include "fmb/variables.h"

enum { KEY_KEEP = 0x200, KEY_ELIMINATE, KEY_TO, KEY_CLASSES };

static const struct argp_option options[] = {
    {"keep", KEY_KEEP, "NAMES", 0, "Project on these variables (x,y)", 1},
    {"eliminate", KEY_ELIMINATE, "NAMES", 0, "Eliminate these variables (z,t)", 1},
    {"to", KEY_TO, APP_FORMATS_TO, 0,
     "Write this format (default: that of FILE where it can be written, else fmb)", 1},
    {"classes", KEY_CLASSES, "FILE", OPTION_ARG_OPTIONAL,
     "Print one row of each class of rows that symmetries map to one another, with their "
     "number; symmetries of the projection in FILE, else those of --symmetry",
     2},
    {0}};

typedef struct request {
    app_names keep, eliminate;
    fmb_format to;
    bool classes;
    const char *classes_file; /* or NULL */
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
            argp_error(state, "--to: expected " APP_FORMATS_TO ", found '%s'", arg);
        return 0;
    case KEY_CLASSES:
        r->classes = true;
        r->classes_file = arg;
        return 0;
    case ARGP_KEY_END:
        if (r->classes && r->to)
            argp_error(state, "--classes and --to exclude each other: classes are no system");
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
           "system, the same to the letter for all systems with that projection. Without --keep "
           "and --eliminate the file itself must ask for a projection (a "
           "project or eliminate line in .ine, project: in .fmb). The projection of an infeasible "
           "system is the row "
           "0 <= -1. Given symmetries may save work: --symmetry FILE has lines such as "
           "x y z <> y z x, permutations of variables that map rows to rows; --classes "
           "searches for them."
           "\v"
           "Exit codes: 0 done, 1 infeasible, 2 undecided: implied rows, perhaps not all.\n"
           "\n"
           "Examples:\n"
           "  fmb project shape.fmb --keep x,y\n"
           "  fmb project shape.ine --eliminate x4 --to smt2\n"
           "  fmb project cone.fmb --symmetry cone.sym --classes\n",
    .own = &own,
    .takes_symmetries = true,
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

/* The kept variables; symmetries of FILE, given or found, or NULL; classes of rows of the answer.
 */
typedef struct task {
    int *vars, n;
    fmb_permutations *symmetries;
} task;

static int take_symmetries_of_file(app_session *s, task *t)
{
    if (!s->ask->symmetry)
        return APP_YES;
    int code = app_source_read_symmetries(&s->ask->source, s->ask->symmetry, s->system, t->vars,
                                          t->n, &t->symmetries);
    if (code != APP_YES)
        return code;
    fmb_status st = fmb_solver_set_symmetries(s->solver, t->symmetries);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

/* NULL after a limit, too. */
static int find_symmetries(app_session *s, task *t)
{
    if (t->symmetries || s->ask->options.symmetry == FMB_SYMMETRY_NONE)
        return APP_YES;
    fmb_status st = fmb_symmetries_find(s->solver, s->system, t->vars, t->n, &t->symmetries, NULL);
    if (st == FMB_OK && t->symmetries)
        st = fmb_solver_set_symmetries(s->solver, t->symmetries);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

/* Report classes under symmetries of the answer, which are read from a file. */
static int report_classes_of_file(const app_session *s, const request *r,
                                  const fmb_system *projection)
{
    int n = fmb_system_dim(projection);
    fmb_permutations *symmetries = NULL;
    int *all = app_need(malloc(((size_t)n + 1) * sizeof *all));
    for (int j = 0; j < n; j++)
        all[j] = j;
    int code = app_source_read_symmetries(&s->ask->source, r->classes_file, projection, all, n,
                                          &symmetries);
    if (code == APP_YES)
        code = app_classes_report(s, projection, symmetries, all, n);
    fmb_permutations_free(symmetries);
    free(all);
    return code;
}

static int report(app_session *s, const request *r, task *t, const fmb_system *projection)
{
    if (!r->classes)
        return app_projection_report(s, projection,
                                     r->to ? r->to : app_source_written(&s->ask->source));
    return r->classes_file ? report_classes_of_file(s, r, projection)
                           : app_classes_report(s, projection, t->symmetries, t->vars, t->n);
}

int cmd_project(int argc, char **argv)
{
    app_ask ask;
    request r = {.keep = {.option = "--keep"}, .eliminate = {.option = "--eliminate"}};
    app_ask_parse(&ask, &usage, &r, argc, argv);
    if (ask.proof)
        ask.options.evidence = FMB_EVIDENCE_WHOLE;
    app_session s;
    task t = {0};
    fmb_system *projection = NULL;
    int code = app_session_open(&s, &ask);
    if (code == 0 && !r.classes)
        code = app_ask_exact_rows(&ask);
    if (code == 0)
        code = choose(&r, s.system, &t.vars, &t.n);
    if (code == 0)
        code = take_symmetries_of_file(&s, &t);
    if (code == 0) {
        app_integers_note(&s);
        app_session_begin(&s);
    }
    if (code == 0 && r.classes && !r.classes_file)
        code = find_symmetries(&s, &t);
    if (code == 0) {
        fmb_status st = fmb_project(s.solver, s.system, t.vars, t.n, &projection, &s.result);
        code = app_session_end(&s, st);
    }
    if (code == 0)
        code = report(&s, &r, &t, projection);
    fmb_system_free(projection);
    fmb_permutations_free(t.symmetries);
    free(t.vars);
    return app_session_close(&s, code);
}
