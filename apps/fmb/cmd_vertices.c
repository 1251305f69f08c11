/* cmd_vertices.c: fmb vertices FILE. */
#include <stdlib.h>

#include "common/exit_code.h"
#include "common/json.h"
#include "common/message.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

static const app_usage usage = {
    .args = "FILE",
    .doc = "Vertices, rays and lines of the system in FILE, as a V-representation (.ext) of cddlib "
           "and "
           "lrslib: a row (1, x) is a vertex, (0, x) a ray, one on the linearity line a line. Rows "
           "with "
           "< are read as <=. With --decimal, comments before it list each in decimals."
           "\v"
           "Exit codes: 0 done, 1 infeasible, 2 undecided: vertices and rays, perhaps not all.\n"
           "\n"
           "Examples:\n"
           "  fmb vertices cube.ine > cube.ext\n"
           "  fmb vertices cube.ine --json\n",
};

/* ---- the report ------------------------------------------------------------------------------ */

static json_t *generators_json(const fmb_generators *g, fmb_generator_kind kind, int digits)
{
    json_t *list = app_need(json_array());
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        if (fmb_generators_kind(g, i) == kind)
            app_json_append(list, app_json_generator(g, i, digits));
    return list;
}

static void report_json(const app_session *s, const fmb_generators *g)
{
    int digits = s->ask->digits;
    json_t *obj = app_verdict_json(s);
    if (g && s->result.stop != FMB_STOP_DONE)
        app_json_set(obj, "inner", json_true());
    if (g) {
        app_json_set(obj, "vertices", generators_json(g, FMB_VERTEX, digits));
        app_json_set(obj, "rays", generators_json(g, FMB_RAY, digits));
        app_json_set(obj, "lines", generators_json(g, FMB_LINE, digits));
    }
    app_json_set_stats(obj, &s->result.stats);
    app_json_print(obj);
}

/* "* row 1: vertex (0.5, ~0.333333)": the file itself is exact. */
static void print_decimals(const fmb_generators *g, int digits)
{
    static const char *const word[] = {
        [FMB_VERTEX] = "vertex", [FMB_RAY] = "ray", [FMB_LINE] = "line"};
    mpq_t q;
    mpq_init(q);
    for (size_t i = 0; i < fmb_generators_size(g); i++) {
        printf("* row %zu: %s (", i + 1, word[fmb_generators_kind(g, i)]);
        for (int j = 0; j < fmb_generators_dim(g); j++) {
            fmb_generators_coordinate_q(g, i, j, q);
            char *text = app_number(q, digits, APP_NEAREST);
            printf("%s%s", j > 0 ? ", " : "", text);
            free(text);
        }
        puts(")");
    }
    mpq_clear(q);
}

/* Is the answer complete? INFEASIBLE is, even after a limit; FEASIBLE alone is not. */
static bool is_finished(const app_session *s)
{
    return s->result.verdict == FMB_INFEASIBLE || s->result.stop == FMB_STOP_DONE;
}

/* After a limit the generators are incomplete. */
static int exit_code(const app_session *s, const fmb_generators *g)
{
    if (is_finished(s))
        return app_session_verdict_code(s);
    return app_session_undecided(s, g ? "vertices and rays, perhaps not all" : "no vertices");
}

static int report(const app_session *s, const fmb_generators *g)
{
    if (s->ask->json)
        report_json(s, g);
    else if (!g && is_finished(s))
        app_verdict_print(s);
    else if (g && app_session_reports(s)) {
        if (s->ask->digits > 0)
            print_decimals(g, s->ask->digits);
        fmb_status st = fmb_generators_write(g, stdout);
        if (st != FMB_OK && st != FMB_ERR_IO)
            return app_status_error(st);
    }
    return exit_code(s, g);
}

int cmd_vertices(int argc, char **argv)
{
    app_ask ask;
    app_session s;
    fmb_generators *g = NULL;
    app_ask_parse(&ask, &usage, NULL, argc, argv);
    int code = app_session_open(&s, &ask);
    if (code == 0) {
        app_integers_note(&s);
        app_session_begin(&s);
        fmb_status st = fmb_generate(s.solver, s.system, &g, &s.result);
        code = app_session_end(&s, st);
    }
    if (code == 0)
        code = report(&s, g);
    fmb_generators_free(g);
    return app_session_close(&s, code);
}
