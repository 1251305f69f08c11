/* lifted.c: see lifted.h. */
#include "fmb/lifted.h"

#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "common/nearest.h"
#include "common/text.h"
#include "fmb/integers.h"
#include "fmb/projection.h"

enum { KEY_TO = 0x200, KEY_LIFTED };

static const struct argp_option options[] = {
    {"to", KEY_TO, APP_FORMATS_TO, 0,
     "Write this format (default: that of the first FILE with a system where it can be written, "
     "else fmb; ine if there are V-representations alone)",
     1},
    {"lifted", KEY_LIFTED, "OUT", 0,
     "Write to OUT the system whose projection this is: a proof is about it", 2},
    {0}};

typedef struct request {
    const app_lifted *command;
    const app_ask *ask;
    const char *more[APP_MOST_FILES]; /* after the first */
    size_t files;
    fmb_format to;
    const char *lifted;
} request;

/* ---- command line ---------------------------------------------------------------------------- */

static void check_words(const request *r, struct argp_state *state)
{
    size_t inputs = r->ask->source.file && strcmp(r->ask->source.file, "-") == 0;
    for (size_t i = 0; i < r->files; i++)
        inputs += strcmp(r->more[i], "-") == 0;
    if (inputs > 1)
        argp_error(state, "only one FILE can be standard input");
    if (r->command->map && r->ask->source.file && r->files == 0)
        argp_error(state, "MAP is missing (- is standard input)");
    if (r->ask->proof && !r->lifted)
        argp_error(state, "--proof: it is about the lifted system: --lifted OUT writes that");
    if (r->lifted && strcmp(r->lifted, "-") == 0)
        argp_error(state, "--lifted: expected a file, as the answer goes to standard output");
    if (r->lifted && r->ask->proof && strcmp(r->lifted, r->ask->proof) == 0)
        argp_error(state, "--lifted and --proof both want '%s'", r->lifted);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    request *r = state->input;
    switch (key) {
    case KEY_TO:
        if (!app_format_to(arg, &r->to))
            argp_error(state, "--to: expected " APP_FORMATS_TO ", found '%s'", arg);
        return 0;
    case KEY_LIFTED:
        r->lifted = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (r->files == (r->command->map ? 1 : APP_MOST_FILES))
            return ARGP_ERR_UNKNOWN;
        r->more[r->files++] = arg;
        return 0;
    case ARGP_KEY_END:
        check_words(r, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp own = {.options = options, .parser = parse};

/* ---- the files ------------------------------------------------------------------------------- */

static app_source source_of(const request *r, size_t i)
{
    app_source src = r->ask->source;
    if (i > 0)
        src.file = r->more[i - 1];
    return src;
}

static const char *file_of(const request *r, size_t i)
{
    return app_file_shown(source_of(r, i).file);
}

static app_polyhedra open_polyhedra(const request *r)
{
    size_t n = r->command->map ? 1 : r->files + 1;
    return (app_polyhedra){.n = n,
                           .system = app_need(calloc(n, sizeof(fmb_system *))),
                           .generator = app_need(calloc(n, sizeof(fmb_generators *)))};
}

static void close_polyhedra(app_polyhedra *p)
{
    for (size_t i = 0; i < p->n; i++) {
        fmb_system_free(p->system[i]);
        fmb_generators_free(p->generator[i]);
    }
    fmb_system_free(p->graph);
    free(p->generator);
    free(p->system);
}

/* The first with rows; n if there is none. */
static size_t first_with_rows(const app_polyhedra *p)
{
    size_t i = 0;
    while (i < p->n && p->generator[i])
        i++;
    return i;
}

static bool keeps(const fmb_system *s, int j)
{
    return !fmb_system_asks_projection(s) || fmb_system_is_kept(s, j);
}

static int count_kept(const fmb_system *s)
{
    int n = 0;
    for (int j = 0; j < fmb_system_dim(s); j++)
        n += keeps(s, j);
    return n;
}

/* Coordinates are named as the variables of the first with rows, if there is one. */
static int check_dimensions(const request *r, const app_polyhedra *p)
{
    size_t first = first_with_rows(p);
    int expected =
        first < p->n ? count_kept(p->system[first]) : fmb_generators_dim(p->generator[0]);
    for (size_t i = 0; i < p->n; i++) {
        int found = p->generator[i] ? fmb_generators_dim(p->generator[i]) : expected;
        if (found != expected)
            return app_error_at((app_place){.file = file_of(r, i)}, APP_BAD_INPUT,
                                "expected %d coordinates, found %d", expected, found);
    }
    return APP_YES;
}

static int lift_all_generators(app_polyhedra *p)
{
    size_t first = first_with_rows(p);
    const fmb_system *like = first < p->n ? p->system[first] : NULL;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < p->n; i++)
        if (p->generator[i])
            st = fmb_lift_generators(p->generator[i], like, &p->system[i]);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

static int refuse_name(const request *r, const fmb_system *expected, size_t i, const char *name)
{
    char hint[APP_HINT_SIZE];
    app_nearest near = app_nearest_to(name);
    for (int j = 0; j < fmb_system_dim(expected); j++)
        if (keeps(expected, j))
            app_nearest_try(&near, fmb_system_name(expected, j));
    char *shown = app_text(name, APP_TEXT_TERMINAL);
    int code = app_error_at((app_place){.file = file_of(r, i)}, APP_BAD_INPUT,
                            "variable '%s' is not one of %s%s", shown, file_of(r, 0),
                            app_nearest_hint(&near, hint));
    free(shown);
    return code;
}

/* All have the variables of the first. */
static int check_names(const request *r, const app_polyhedra *p)
{
    const fmb_system *first = p->system[0];
    for (size_t i = 1; i < p->n; i++) {
        const fmb_system *s = p->system[i];
        for (int j = 0; j < fmb_system_dim(s); j++) {
            const char *name = fmb_system_name(s, j);
            int found = fmb_system_find(first, name);
            if (keeps(s, j) && (found < 0 || !keeps(first, found)))
                return refuse_name(r, first, i, name);
        }
        if (count_kept(s) != count_kept(first))
            return app_error_at((app_place){.file = file_of(r, i)}, APP_BAD_INPUT,
                                "expected %d variables, as in %s, found %d", count_kept(first),
                                file_of(r, 0), count_kept(s));
    }
    return APP_YES;
}

static bool are_generators_enough(const request *r, const app_polyhedra *p)
{
    return r->command->query_of_generators && !r->lifted && first_with_rows(p) == p->n;
}

static int read_map(const request *r, app_polyhedra *p)
{
    app_source src = source_of(r, 1);
    src.format = FMB_FORMAT_TEXT; /* whatever its name says */
    return app_source_read_graph(&src, p->system[0], &p->graph);
}

static int read_polyhedra(const request *r, app_polyhedra *p)
{
    int code = APP_YES;
    for (size_t i = 0; code == APP_YES && i < p->n; i++) {
        app_source src = source_of(r, i);
        code = app_source_read_polyhedron(&src, &p->system[i], &p->generator[i]);
    }
    if (code == APP_YES)
        code = check_dimensions(r, p);
    if (code != APP_YES || are_generators_enough(r, p))
        return code;
    code = lift_all_generators(p);
    if (code == APP_YES)
        code = check_names(r, p);
    return code == APP_YES && r->command->map ? read_map(r, p) : code;
}

/* ---- the query ------------------------------------------------------------------------------- */

static fmb_format format_of_answer(const request *r, const app_polyhedra *p)
{
    size_t first = first_with_rows(p);
    if (r->to)
        return r->to;
    app_source src = source_of(r, first < p->n ? first : 0);
    return first < p->n ? app_source_written(&src) : FMB_FORMAT_INE;
}

static int write_lift(const request *r, const fmb_system *lift, FILE *to)
{
    if (!to || !lift) {
        app_file_discard(to);
        return APP_YES;
    }
    app_source src = {.file = r->lifted};
    fmb_status st = fmb_system_write(lift, app_source_written(&src), to);
    int code = app_file_close(to, r->lifted);
    return st == FMB_OK || st == FMB_ERR_IO ? code : app_status_error(st);
}

/* From now on the session is about the lift. */
static int ask(app_session *s, const request *r, const app_polyhedra *p, fmb_system **out)
{
    FILE *to = NULL;
    app_lifted_query *query =
        are_generators_enough(r, p) ? r->command->query_of_generators : r->command->query;
    int code = r->lifted ? app_file_create(r->lifted, &to) : APP_YES;
    if (code != APP_YES)
        return code;
    for (size_t i = 0; i < p->n; i++)
        app_integers_note_of(s, p->system[i]);
    app_session_begin(s);
    fmb_status st = query(s->solver, p, &s->system, out, &s->result);
    code = app_session_end(s, st);
    if (code != APP_YES) {
        app_file_discard(to);
        return code;
    }
    return write_lift(r, s->system, to);
}

int app_lifted_run(const app_lifted *command, int argc, char **argv)
{
    const app_usage usage = {.args = command->args, .doc = command->doc, .own = &own};
    app_ask question;
    app_session s;
    fmb_system *out = NULL;
    request r = {.command = command, .ask = &question};
    app_ask_parse(&question, &usage, &r, argc, argv);
    if (question.proof)
        question.options.evidence = FMB_EVIDENCE_WHOLE;
    app_polyhedra p = open_polyhedra(&r);
    int code = app_session_open_solver(&s, &question);
    if (code == APP_YES)
        code = app_ask_exact_rows(&question);
    if (code == APP_YES)
        code = app_session_end_reading(&s, read_polyhedra(&r, &p));
    if (code == APP_YES)
        code = app_session_open_outputs(&s);
    if (code == APP_YES)
        code = ask(&s, &r, &p, &out);
    if (code == APP_YES)
        code = app_projection_report(&s, out, format_of_answer(&r, &p));
    fmb_system_free(out);
    close_polyhedra(&p);
    return app_session_close(&s, code);
}
